#!/usr/bin/env python3
"""Changes the sources in small ways, one at a time, and counts how many of the changes a test finds.

    tools/mutations.py [--seed 1] [--count 60]

Works on a clean checkout: each change is compiled in build-mutations, tried by the quick tests of its
own room, where these find nothing by those of its layer, then by those of all layers, and taken back.
Only what these tests need is built. Changes are drawn over all rooms of src in turn, but those of the
window. Writes a table; exit status 1 where the tree is not clean. A change may mean the same as
before (a limit nobody reaches): read what was not found.
"""

import argparse
import json
import pathlib
import random
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build-mutations"
CHANGES = [
    (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "),
    (r" == ", " != "), (r" != ", " == "), (r" && ", " || "), (r" \|\| ", " && "),
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "),
    (r" \+= ", " -= "), (r" -= ", " += "), (r"return true;", "return false;"),
    (r"return false;", "return true;"), (r"if \(!", "if ("), (r"\b0\.5\b", "0.6"),
    (r"\bfmin \(", "fmax ("), (r"\bfmax \(", "fmin ("), (r"\bcos \(", "sin ("),
    (r"^  (\w[\w.>\[\]-]*) = [^=].*;$", r"  (void) \1;"),
    (r"^    (\w[\w.>\[\]-]*) = [^=].*;$", r"    (void) \1;"),
    (r"\bcontinue;", "break;"), (r"\bi \+ 1\b", "i"),
]


def places(path):
    """Lines of a file that are code and can be changed: number, line, changed line."""
    found = []
    comment = False
    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n")):
        start = comment
        comment = (comment or "/*" in line) and "*/" not in line
        if start or comment or line.lstrip().startswith(("#", "*", "/*", "//")) or '"' in line:
            continue
        if not line.startswith("  ") or "for (" in line and " = " not in line:
            continue
        for pattern, new in CHANGES:
            for match in re.finditer(pattern, line):
                changed = line[:match.start()] + match.expand(new) + line[match.end():]
                found.append((number, line, changed))
    return found


def run(*command, seconds=1800):
    """Whether a command ends well in time."""
    try:
        return subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=seconds, check=False).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def quick_tests():
    """Names of the quick tests, each with its layer."""
    shown = subprocess.run(["meson", "introspect", "--tests", str(BUILD)], cwd=ROOT, check=True,
                           stdout=subprocess.PIPE).stdout
    found = {}
    for test in json.loads(shown):
        suites = {suite.split(":")[-1] for suite in test["suite"]}
        if not suites & {"slow", "all", "checks"}:
            found[test["name"]] = min(suites)
    return found


def found_by(path, layers):
    """Which tests find a change of a file: those nearest to it are tried first."""
    layer, room = path.relative_to(ROOT / "src").parts[:2]
    left = set(layers)
    own = {name for name in layers if name in (f"{layer}-{room}", layer)}
    for who, names in (("its room", own), ("its layer", {n for n in left if layers[n] == layer}),
                       ("another layer", left)):
        names = sorted(names & left)
        left -= set(names)
        if names and not run("meson", "test", "-C", str(BUILD), "--maxfail", "1",
                             "--timeout-multiplier", "4", *names):
            return who
    return "**nobody**"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=60)
    given = parser.parse_args()
    if not run("git", "diff", "--quiet", "--", "src"):
        sys.exit("mutations: src has changes that are not committed")
    if not BUILD.exists():
        run("meson", "setup", str(BUILD), "-Dapp=disabled", "-Dwerror=false")
    layers = quick_tests()
    run("ninja", "-C", str(BUILD), seconds=7200)  # with translations, which no test names
    if not run("meson", "test", "-C", str(BUILD), "--timeout-multiplier", "4", *sorted(layers),
               seconds=7200):
        sys.exit("mutations: the tests fail without any change")
    chance = random.Random(given.seed)
    rooms = sorted({path.parent for path in (ROOT / "src").rglob("*.c") if "app" not in path.parts})
    chance.shuffle(rooms)
    found = done = 0
    print("| change | found by |\n| --- | --- |", flush=True)
    while done < given.count:
        room = rooms[done % len(rooms)]
        choice = [(path, place) for path in sorted(room.glob("*.c")) for place in places(path)]
        if not choice:
            rooms.remove(room)
            continue
        path, (number, old, new) = chance.choice(choice)
        whole = path.read_text(encoding="utf-8")
        lines = whole.split("\n")
        lines[number] = new
        path.write_text("\n".join(lines), encoding="utf-8")
        try:
            if not run("ninja", "-C", str(BUILD), f"../{path.relative_to(ROOT)}^"):
                continue  # the compiler finds it
            by = found_by(path, layers)
        finally:
            path.write_text(whole, encoding="utf-8")
        done += 1
        found += by != "**nobody**"
        where = f"{path.relative_to(ROOT / 'src')}:{number + 1}"
        print(f"| {where} `{old.strip()}` → `{new.strip()}` | {by} |", flush=True)
    print(f"\n{found} of {done} found, seed {given.seed}")


if __name__ == "__main__":
    main()
