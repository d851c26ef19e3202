#!/usr/bin/python3
"""Makes manual pages and completions of what quoin-cli says of itself.

    quoin-cli --describe | commands.py FORM VERSION [EXTRA] >OUT

FORM is bash, zsh, fish, markdown, man, or man:SUBCOMMAND. EXTRA is the frame of the overall manual
page, whose line @SUBCOMMANDS@ is replaced by the list of them.
"""

import re
import sys


def choices(value, between):
    """Words to choose from: all of "cairo|gl" and "A|B|C", "last" of "N|last", none of "TEXT"."""
    words = value.split(between)
    letters = all(re.fullmatch("[A-Z]", word) for word in words)
    return [w for w in words if len(words) > 1 and (letters or re.fullmatch("[a-z][a-z0-9/-]*", w))]


class Option:
    def __init__(self, name, short, kind, many, value, text):
        self.name, self.kind, self.many, self.value, self.text = name, kind, many == "many", value, text
        self.short = None if short == "-" else short
        self.listed = "," in value and "|" not in value  # several, with commas between
        self.choices = choices(value, "," if self.listed else "|")
        if kind == "file" and value[:1].isupper():  # "OUT.png|svg": endings
            self.choices = []

    def spelled(self):
        names = ([f"-{self.short}"] if self.short else []) + [f"--{self.name}"]
        return ", ".join(names) + (f"={self.value}" if self.value else "")


class Subcommand:
    def __init__(self, name, arguments, summary, text):
        self.name, self.arguments, self.summary, self.text = name, arguments, summary, text
        self.options = []
        first = arguments.split(" ")[0]
        self.choices = choices(first.strip("[]…"), "|")
        self.repeated = first.endswith("…")

    def all_options(self):
        return self.options + [Option("help", "h", "flag", "once", "", "Show help options")]


def read(lines):
    found = []
    for line in lines:
        kind, *fields = line.rstrip("\n").split("\t")
        if kind == "subcommand":
            found.append(Subcommand(*fields))
        else:
            found[-1].options.append(Option(*fields))
    return found


def top(subcommands):
    return [s for s in subcommands if " " not in s.name]


def actions(subcommands, name):
    return [s for s in subcommands if s.name.startswith(name + " ")]


def bash(subcommands):
    """Words for the subcommand, then for the option before the cursor, then options or files."""
    out = ["# Completion of quoin-cli for bash.", "_quoin_cli()", "{",
           "  local cur prev command head", "  COMPREPLY=()",
           "  cur=${COMP_WORDS[COMP_CWORD]}", "  prev=${COMP_WORDS[COMP_CWORD-1]}",
           "  command=${COMP_WORDS[1]}", "  if ((COMP_CWORD == 1)); then",
           f"    COMPREPLY=($(compgen -W '{' '.join(s.name for s in top(subcommands))} --help --version'"
           " -- \"$cur\"))",
           "    return", "  fi"]
    for parent in top(subcommands):
        inner = actions(subcommands, parent.name)
        if inner:
            words = " ".join(s.name.split(" ")[1] for s in inner)
            out += [f"  if [[ $command == {parent.name} ]]; then",
                    "    if ((COMP_CWORD == 2)); then",
                    f"      COMPREPLY=($(compgen -W '{words} --help' -- \"$cur\"))",
                    "      return", "    fi", '    command="$command ${COMP_WORDS[2]}"', "  fi"]
    out.append('  case "$command $prev" in')
    for s in subcommands:
        for option in s.all_options():
            if option.kind == "flag":
                continue
            keys = [f"'{s.name} --{option.name}'"] + ([f"'{s.name} -{option.short}'"] if option.short else [])
            words, files = f"compgen -W '{' '.join(option.choices)}'", option.kind == "file"
            if option.listed:
                words = 'head=${cur%"${cur##*,}"}; ' + words + ' -P "$head" -- "${cur##*,}"'
            else:
                words += ' -- "$cur"'
            if files:
                words += '; compgen -f -- "$cur"'
            reply = f"COMPREPLY=($({words}))" if option.choices or files else ":"
            if files:
                reply += "; compopt -o filenames 2>/dev/null"
            out.append(f"    {'|'.join(keys)}) {reply}; return ;;")
    out += ["  esac", '  case "$command" in']
    for s in subcommands:
        words = " ".join("--" + o.name for o in s.all_options())
        out += [f"    '{s.name}')", f"      if [[ $cur == -* ]]; then",
                f"        COMPREPLY=($(compgen -W '{words}' -- \"$cur\"))", "        return", "      fi"]
        if s.choices:
            out += [f"      COMPREPLY=($(compgen -W '{' '.join(s.choices)}' -- \"$cur\"))", "      return"]
        out.append("      ;;")
    out += ["  esac", '  COMPREPLY=($(compgen -f -- "$cur"))', "  compopt -o filenames 2>/dev/null",
            "}", "complete -F _quoin_cli quoin-cli"]
    return "\n".join(out) + "\n"


def zsh_text(text):
    for character in "\\[]:'":
        text = text.replace(character, "'\\''" if character == "'" else "\\" + character)
    return text


def zsh_arguments(s):
    """The arguments of _arguments for one subcommand."""
    lines = []
    for o in s.all_options():
        value = ""
        if o.kind != "flag":
            words = " ".join(o.choices)
            action = (f"_values -s , value {words}" if o.listed
                      else f"_alternative \"words:value:({words})\" \"files:file:_files\"" if words and o.kind == "file"
                      else f"({words})" if words else "_files" if o.kind == "file" else " ")
            value = f":{zsh_text(o.value)}:{action}"
        repeat = "*" if o.many else ""
        text = f"[{zsh_text(o.text)}]{value}'"
        equals = "" if o.kind == "flag" else "="
        lines.append(f"'{repeat}--{o.name}{equals}{text}")
        if o.short:
            lines.append(f"'{repeat}-{o.short}{text}")
    if s.choices:
        lines.append(f"'{'*' if s.repeated else '1'}:name:({' '.join(s.choices)})'")
    if not (s.choices and s.repeated):
        lines.append("'*:file:_files'")
    return " \\\n        ".join(lines)


def zsh(subcommands):
    out = ["#compdef quoin-cli", "# Completion of quoin-cli for zsh.", "_quoin-cli() {",
           "  local context state state_descr line", "  typeset -A opt_args",
           "  _arguments -C '--help[Show help options]' '--version[Show the version]' "
           "'1:subcommand:->subcommand' '*::argument:->argument'",
           "  case $state in", "  subcommand)", "    local -a names=("]
    out += [f"      '{s.name}:{zsh_text(s.summary)}'" for s in top(subcommands)]
    out += ["    )", "    _describe subcommand names ;;", "  argument)", "    case $words[1] in"]
    for s in top(subcommands):
        inner = actions(subcommands, s.name)
        if not inner:
            out += [f"    {s.name})", f"      _arguments {zsh_arguments(s)} ;;"]
            continue
        out += [f"    {s.name})", "      if ((CURRENT == 2)); then", "        local -a actions=("]
        out += [f"          '{a.name.split(' ')[1]}:{zsh_text(a.summary)}'" for a in inner]
        out += ["        )", "        _describe action actions", "        return", "      fi",
                "      shift words; ((CURRENT--))", "      case $words[1] in"]
        for a in inner:
            out += [f"      {a.name.split(' ')[1]})", f"      _arguments {zsh_arguments(a)} ;;"]
        out += ["      esac ;;"]
    out += ["    esac ;;", "  esac", "}", '_quoin-cli "$@"']
    return "\n".join(out) + "\n"


def fish_text(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish(subcommands):
    names = " ".join(s.name for s in top(subcommands))
    out = ["# Completion of quoin-cli for fish.",
           f"complete -c quoin-cli -n 'not __fish_seen_subcommand_from {names}' -f"]
    for s in top(subcommands):
        out.append(f"complete -c quoin-cli -n 'not __fish_seen_subcommand_from {names}' "
                   f"-a {s.name} -d {fish_text(s.summary)}")
    for name in ("help", "version"):
        out.append(f"complete -c quoin-cli -n 'not __fish_seen_subcommand_from {names}' -l {name}")
    for s in subcommands:
        words = s.name.split(" ")
        inner = [a.name.split(" ")[1] for a in actions(subcommands, s.name)]
        seen = "; and ".join(f"__fish_seen_subcommand_from {word}" for word in words)
        if inner:
            seen += f"; and not __fish_seen_subcommand_from {' '.join(inner)}"
            for a in actions(subcommands, s.name):
                out.append(f"complete -c quoin-cli -n '{seen}' -f -a {a.name.split(' ')[1]} "
                           f"-d {fish_text(a.summary)}")
        if s.choices:
            out.append(f"complete -c quoin-cli -n '{seen}' -a '{' '.join(s.choices)}'")
        for o in s.all_options():
            line = f"complete -c quoin-cli -n '{seen}' -l {o.name}"
            line += f" -s {o.short}" if o.short else ""
            words = " ".join(o.choices)
            if o.listed:
                line += f" -x -a '(__fish_complete_list , \"string split \\\" \\\" \\\"{words}\\\"\")'"
            elif o.choices:
                line += f" {'-r' if o.kind == 'file' else '-x'} -a '{words}'"
            elif o.kind != "flag":
                line += " -r" if o.kind == "file" else " -x"
            out.append(f"{line} -d {fish_text(o.text)}")
    return "\n".join(out) + "\n"


def roff(text):
    return re.sub(r"(?m)^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"))


def man_options(s):
    out = []
    for o in s.all_options():
        out += [".TP", f".B {roff(o.spelled())}", roff(o.text + ("" if o.text.endswith(".") else "."))]
    return out


def man(subcommands, name, version):
    s = next(s for s in subcommands if s.name == name)
    dashed = name.replace(" ", "-")
    out = [f'.TH QUOIN-CLI-{dashed.upper()} 1 "" "quoin {version}" "User Commands"', ".SH NAME",
           f"quoin\\-cli\\-{roff(dashed)} \\- {roff(s.summary[0].lower() + s.summary[1:])}",
           ".SH SYNOPSIS", f".B quoin\\-cli {roff(name)}", roff(f"[OPTION]... {s.arguments}".replace("…", "..."))]
    out += [".SH DESCRIPTION", roff(s.summary) + ".", roff(s.text)]
    inner = actions(subcommands, name)
    if inner:
        out.append(".SH ACTIONS")
        for a in inner:
            out += [".TP", f".B {roff(a.name)} {roff(a.arguments)}", roff(a.summary) + ". " + roff(a.text)]
            for o in a.options:
                out += [".RS", ".TP", f".B {roff(o.spelled())}",
                        roff(o.text + ("" if o.text.endswith(".") else ".")), ".RE"]
    else:
        out += [".SH OPTIONS"] + man_options(s)
    out += [".SH EXIT STATUS", "See", ".BR quoin\\-cli (1).", ".SH SEE ALSO", ".BR quoin\\-cli (1)"]
    return "\n".join(line for line in out if line) + "\n"


def man_frame(subcommands, version, frame):
    rows = []
    for s in top(subcommands):
        rows += [".TP", f".BR quoin\\-cli\\-{s.name} (1)", roff(s.summary) + "."]
    with open(frame, encoding="utf-8") as file:
        return file.read().replace("@VERSION@", version).replace("@SUBCOMMANDS@", "\n".join(rows))


def markdown(subcommands):
    out = ["# Options of quoin-cli", "",
           "The same as `quoin-cli SUBCOMMAND --help`. [Command line](command-line.md) has examples."]
    for s in subcommands:
        if actions(subcommands, s.name):
            continue
        arguments = s.arguments.replace("`", "'")
        out += ["", f"## {s.name}", "", f"{s.summary}.", "", f"    quoin-cli {s.name} [OPTION…] {arguments}"]
        if s.text:
            out += ["", s.text]
        if s.options:
            out += ["", "| option | |", "| --- | --- |"]
            cells = [(f"`{o.spelled()}`", o.text) for o in s.options]
            out += ["| " + " | ".join(c.replace("|", "\\|") for c in row) + " |" for row in cells]
    return "\n".join(out) + "\n"


def main():
    form, version, *extra = sys.argv[1:]
    subcommands = read(sys.stdin)
    if form == "man":
        text = man_frame(subcommands, version, extra[0])
    elif form.startswith("man:"):
        text = man(subcommands, form[4:], version)
    else:
        text = {"bash": bash, "zsh": zsh, "fish": fish, "markdown": markdown}[form](subcommands)
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write(text)


main()
