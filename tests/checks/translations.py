#!/usr/bin/python3
"""Every language of po/LINGUAS has every string of the program, and says the same.

    translations.py SOURCE-ROOT

Strings are gathered as for po/quoin.pot. None may lack a translation or have one marked as fuzzy.
Conversions, line breaks, spaces at both ends and the number of underlines are those of the
original (French puts a space before a colon). Where no two entries of a menu or dialog underline the
same letter, no two of their translations do.
"""

import collections
import gettext
import io
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

# Those of the preset in po/meson.build, and its own.
KEYWORDS = ["_", "N_", "C_:1c,2", "NC_:1c,2", "g_dcgettext:2", "g_dngettext:2,3",
            "g_dpgettext2:2c,3", "X:2"]
CONVERSION = re.compile(r"%(?:\d+\$)?([-+#0]*(?:\d+|\*)?(?:\.\d+)?z?[diouxXeEfgGcsp])|%(%)")


def run(*command, text=b""):
    done = subprocess.run(command, input=text, capture_output=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command[:3])}: {done.stderr.decode()}")
    return done.stdout


def template(files):
    """The catalogue in which every string is its own translation."""
    keywords = ["--keyword=" + keyword for keyword in KEYWORDS]
    empty = run("xgettext", "--from-code=UTF-8", *keywords, "-f", files, "-o", "-")
    empty = re.sub(rb"nplurals=.*;", rb"nplurals=2; plural=(n != 1);", empty)
    return run("msgen", "-", text=empty.replace(b"charset=CHARSET", b"charset=UTF-8"))


def messages(po):
    """{key: its forms}, without those that are fuzzy or empty."""
    catalogue = gettext.GNUTranslations(io.BytesIO(run("msgfmt", "-o", "-", "-", text=po)))._catalog
    found = collections.defaultdict(list)
    for key, form in catalogue.items():
        found[key[0] if isinstance(key, tuple) else key].append(form)
    found.pop("", None)
    return found


def signature(text):
    return (sorted(a + b for a, b in CONVERSION.findall(text)), text.count("\n"), text.count("_"),
            text[0].isspace() or text[0] in ":;", text[-1].isspace())


def differences(originals, translations):
    for key, forms in originals.items():
        if key not in translations:
            yield f"not translated, or fuzzy: {key!r}"
        for form, translation in zip(forms, translations.get(key, [])):
            if signature(form) != signature(translation):
                yield f"other conversions, breaks, ends or underlines: {form!r}: {translation!r}"


def groups(ui):
    """The keys of the strings of every menu, and of the rest of a file."""
    found = collections.defaultdict(list)

    def walk(element, group):
        for child in element:
            if child.get("translatable") == "yes" and child.text.count("_") == 1:
                context = child.get("context")
                found[group].append(child.text if context is None else f"{context}\4{child.text}")
            walk(child, child if child.tag == "section" or child.tag == "submenu" else group)

    walk(xml.fromstring(ui), None)
    return found.values()


def underlined_twice(keys, translations):
    texts = collections.defaultdict(set)
    for key in keys:
        text = translations.get(key, ["_" + key])[0]
        texts[text.partition("_")[2][:1].lower()].add(text)
    return [sorted(same) for same in texts.values() if len(same) > 1]


def check_language(originals, translations, files):
    yield from differences(originals, translations)
    for name, ui in files:
        for keys in groups(ui):
            if not underlined_twice(keys, originals):
                for same in underlined_twice(keys, translations):
                    yield f"{name}: one letter is underlined in {', '.join(same)}"


def self_test():
    """Complaints are made where there is something to complain of."""
    head = b'msgid ""\nmsgstr "Content-Type: text/plain; charset=UTF-8\\n"\n\n'
    good = messages(head + b'msgid "_Open %d"\nmsgstr "%d _auf"\n\nmsgid "_Cut"\nmsgstr "_Weg"\n')
    ui = '<interface>' + "".join(
        f'<property translatable="yes">{text}</property>' for text in good) + '</interface>'
    originals = {key: [key] for key in good}
    files = [("a.ui", ui)]
    assert list(check_language(originals, good, files)) == []
    for key, wrong in [("_Open %d", "_auf"), ("_Open %d", "_%s auf"), ("_Cut", "Weg"),
                       ("_Cut", "_Weg\n"), ("_Cut", "_Weg "), ("_Cut", "_ab")]:
        assert len(list(check_language(originals, {**good, key: [wrong]}, files))) == 1, wrong
    fuzzy = messages(head + b'msgid "_Cut"\nmsgstr "_Weg"\n\n'
                     b'#, fuzzy\nmsgid "_Open %d"\nmsgstr "%d _auf"\n')
    assert len(list(check_language(originals, fuzzy, files))) == 1


def main():
    os.chdir(sys.argv[1])
    self_test()
    with open("po/LINGUAS", encoding="utf-8") as file:
        languages = file.read().split()
    with open("po/POTFILES.in", encoding="utf-8") as file:
        interfaces = [name for name in file.read().split() if name.endswith(".ui")]
    files = [(name, open(name, encoding="utf-8").read()) for name in interfaces]
    catalogues = sorted(name[:-3] for name in os.listdir("po") if name.endswith(".po"))
    failures = [] if catalogues == sorted(languages) else [f"po/LINGUAS has not {catalogues}"]
    with open("data/io.github.quoin.Quoin.mime.xml", encoding="utf-8") as file:
        mime = file.read()
    originals = messages(template("po/POTFILES.in"))
    for language in languages:
        path = f"po/{language}.po"
        run("msgfmt", "--check", "-o", os.devnull, path)
        with open(path, "rb") as file:
            translations = messages(file.read())
        failures += [f"{path}: {complaint}"
                     for complaint in check_language(originals, translations, files)]
        if f'xml:lang="{language}"' not in mime:
            failures.append(f"the file type has no name in {language}")
    print("\n".join(failures) or f"{len(originals)} strings in {', '.join(languages)}")
    return 1 if failures else 0


sys.exit(main())
