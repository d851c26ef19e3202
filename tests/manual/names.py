#!/usr/bin/python3
"""What the manual calls the program's parts is what the program calls them.

    names.py SOURCE-ROOT PAGE...

Words in *italics* are strings of the program: in English as in the source, in other languages as in
the catalogue of the page's language. Keys (Ctrl+I, F5, `W`) are those of the tables of actions and
tools. Mnemonics, dots at the end and capitals do not matter; "*Export Result, Animation*" is one name
in a menu after the other.
"""

import glob
import os
import re
import sys

# Titles of books, which are in italics as well.
TITLES = {"Computational strategies for masonry structures"}

MODIFIERS = {"Ctrl": "<Control>", "Shift": "<Shift>", "Maj": "<Shift>", "Alt": "<Alt>"}
KEYS = {"?": "question"}


def catalogue(path):
    """What is translated, and into what."""
    text, found = open(path, encoding="utf-8").read(), {}
    string = r'((?:".*"\n)+)'
    for entry in re.finditer(r"^msgid " + string + r"(?:^msgid_plural " + string + ")?"
                             + r"^msgstr(?:\[0\])? " + string, text, re.M):
        source, target = (re.sub(r'"\n"|^"|"\n$', "", entry[i]) for i in (1, 3))
        found[source.replace('\\"', '"')] = target.replace('\\"', '"')
    return found


def plain(name):
    return name.replace("_", "").replace("…", "").replace("’", "'").strip().rstrip(":").lower()


def prose(text):
    """The page with its line breaks, without blocks of code."""
    return re.sub(r"```.*?```", lambda block: "\n" * block[0].count("\n"), text, flags=re.S)


def unknown_names(page, text, known):
    for found in re.finditer(r"(?<![\w*])\*([^*]+)\*(?![\w*])", prose(text)):
        name = " ".join(found[1].split())
        if plain(name) in known or name in TITLES:
            continue
        if not all(plain(part) in known for part in name.split(",")):
            yield f"{page}:{text_line(text, found.start())}: the program has no “{name}”"


def text_line(text, place):
    return prose(text)[:place].count("\n") + 1


def accelerators(root):
    """(of actions, of tools)"""
    with open(os.path.join(root, "src/app/window/action-table.c"), encoding="utf-8") as file:
        keyed = re.findall(r'(?:ALL|NO_ENTRY|DRAWING),\s*"([^"]+)"', file.read())
        actions = {key.lower() for keys in keyed for key in keys.split()}
    tools = set()
    for path in glob.glob(os.path.join(root, "src/app/tools/tool-*.c")):
        with open(path, encoding="utf-8") as file:
            tools |= {key.upper() for key in re.findall(r'\.accel = "(\w)"', file.read())}
    return actions, tools


def unknown_keys(page, text, actions, tools):
    single = tools | {key.upper() for key in actions if len(key) == 1}
    for found in re.finditer(r"\b((?:(?:Ctrl|Maj|Shift|Alt)\+)+)([A-Z0-9?]\b|\?|F\d+)|\b(F\d+)\b",
                             prose(text)):
        held = "".join(sorted(MODIFIERS[name] for name in (found[1] or "").split("+")[:-1]))
        key = found[2] or found[3]
        if (held + KEYS.get(key, key)).lower() not in actions:
            yield f"{page}:{text_line(text, found.start())}: no action has the key {found[0]}"
    for found in re.finditer(r"`([A-Z])`", prose(text)):
        if found[1] not in single:
            yield f"{page}:{text_line(text, found.start())}: no tool has the key {found[1]}"


def main():
    root, *pages = sys.argv[1:]
    words = catalogue(os.path.join(root, "po/fr.po"))
    known = {"": {plain(word) for word in words},
             "fr": {plain(word) for word in words.values()}}
    actions, tools = accelerators(root)
    assert len(known[""]) > 1000 and len(actions) > 30 and len(tools) > 12
    assert list(unknown_names("test", "press *No Such Button*", known[""]))
    assert list(unknown_keys("test", "Ctrl+7 and `Q`", actions, tools))
    complaints = []
    for page in pages:
        with open(page, encoding="utf-8") as file:
            text = file.read()
        language = os.path.basename(os.path.dirname(page))
        complaints += unknown_names(page, text, known.get(language, known[""]))
        complaints += unknown_keys(page, text, actions, tools)
    print("\n".join(complaints) if complaints else f"{len(pages)} pages")
    sys.exit(1 if complaints else 0)


main()
