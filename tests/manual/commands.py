#!/usr/bin/python3
"""Runs every command of the manual, and every example in Python.

    commands.py SOURCE-ROOT QUOIN-CLI [PAGE...]

Blocks marked sh and python are run page by page, in the order of the page, in a copy of the folder
of examples. All must succeed, and without a warning that names no place in a file: a page shows no
command that has nothing to show. Imports warn of what drawings hold. Every mention of "quoin-cli " at the beginning of a line must stand in
such a block, so that none is left out. Environment: PYTHONPATH and so on for Python; without
QUOIN_LIBRARY its blocks are passed over.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

# Blocks that show what someone else runs: a cluster, a network, a compiler in another folder.
ELSEWHERE = {"console"}


def blocks(text):
    """(language, line, content) of every fenced or indented block."""
    found, inside = [], None
    for number, line in enumerate(text.splitlines(), 1):
        fence = re.match(r"```(\w*)$", line)
        if inside is None and fence:
            inside = (fence.group(1), number, [])
        elif inside is not None and line == "```":
            found.append((inside[0], inside[1], "\n".join(inside[2]) + "\n"))
            inside = None
        elif inside is not None:
            inside[2].append(line)
        elif line.startswith("    "):
            found.append(("", number, line.strip() + "\n"))
    return found


def unmarked(page, text):
    """Commands that no test would run."""
    for language, number, content in blocks(text):
        if language not in ELSEWHERE | {"sh"} and re.search(r"^quoin-cli ", content, re.M):
            yield f"{page}:{number}: a command outside a block of sh"


def run(page, text, program, examples):
    with tempfile.TemporaryDirectory() as folder:
        tools, work = os.path.join(folder, "bin"), os.path.join(folder, "examples")
        os.mkdir(tools)
        os.symlink(os.path.abspath(program), os.path.join(tools, "quoin-cli"))
        shutil.copytree(examples, work)
        environment = dict(os.environ, PATH=tools + ":" + os.environ["PATH"])
        for language, number, content in blocks(text):
            if language == "sh":
                command = ["bash", "-euo", "pipefail", "-c", content]
            elif language == "python" and "QUOIN_LIBRARY" in environment:
                command = ["/usr/bin/python3", "-c", content]
            else:
                continue
            done = subprocess.run(command, cwd=work, env=environment, capture_output=True, text=True)
            told = re.search(r"^quoin-cli: warning: (?!\S+:\d+:\d+: )", done.stderr, re.M)
            if done.returncode != 0 or told and "quoin-cli import " not in content:
                yield f"{page}:{number}: exit code {done.returncode}\n{content}{done.stdout}{done.stderr}"


def outline(text):
    """What a page is made of, whatever its language: (what, line)."""
    code = {number: content for _, number, content in blocks(text)}
    found, inside = [], False
    for number, line in enumerate(text.splitlines(), 1):
        if number in code:
            found.append(("a block: " + code[number], number))
        inside ^= line.startswith("```")
        heading = re.match(r"#+ ", line)
        if inside:
            continue
        if heading:
            found.append((f"a heading of level {len(heading[0]) - 1}", number))
        elif line.startswith("| "):
            found.append((f"a row of {line.count(' |')} cells", number))
        elif line.startswith("!["):
            found.append(("a picture", number))
    return found


def translated(page, text):
    """A translated page has the parts of the page that it translates, in the same order."""
    folder, name = os.path.split(page)
    with open(os.path.join(os.path.dirname(folder), name), encoding="utf-8") as file:
        wanted = outline(file.read())
    present = outline(text)
    for (what, number), (there, _) in zip(present, wanted):
        if what != there:
            yield f"{page}:{number}: {what}, and in English {there}"
            return
    if len(present) != len(wanted):
        yield f"{page}: {len(present)} parts, and in English {len(wanted)}"


def self_test(program, examples):
    """What must be found is found."""
    wrong = "```sh\nquoin-cli solve 01-sliding-block.quoin --no-such-option\n```\n"
    assert list(run("test", wrong, program, examples))
    right = "```sh\nquoin-cli check 01-sliding-block.quoin\n```\n"
    assert not list(run("test", right, program, examples))
    told = "```sh\nquoin-cli check 01-sliding-block.quoin\nquoin-cli figures 01-sliding-block.quoin\n```\n"
    assert list(run("test", told, program, examples))
    assert not list(unmarked("test", right))
    assert list(unmarked("test", "```\nquoin-cli check a.quoin\n```\n"))
    assert list(unmarked("test", "text\n\n    quoin-cli check a.quoin\n"))
    assert [what for what, _ in outline("# A\n\n| a | b |\n\n![c](d)\n" + right)] == [
        "a heading of level 1", "a row of 2 cells", "a picture",
        "a block: quoin-cli check 01-sliding-block.quoin\n"]


def main():
    root, program, *pages = sys.argv[1:]
    examples = os.path.join(root, "examples")
    self_test(program, examples)
    complaints, count = [], 0
    for page in pages:
        with open(page, encoding="utf-8") as file:
            text = file.read()
        count += sum(language in ("sh", "python") for language, _, _ in blocks(text))
        complaints += unmarked(page, text)
        if os.path.basename(os.path.dirname(page)) == "fr":
            complaints += translated(page, text)
        else:
            complaints += run(page, text, program, examples)
    assert count > 20, "hardly any block was found"
    print("\n".join(complaints) if complaints else f"{count} blocks")
    sys.exit(1 if complaints else 0)


main()
