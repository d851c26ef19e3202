#!/usr/bin/python3
"""The tables of docs/manual/verification.md and of its translations.

    verification.py QUOIN-CLI PAGE...            computes them and writes them into the pages
    verification.py --check QUOIN-CLI PAGE...    compares them with what the program computes now

The first page is in English and has the names that the program prints; in the others the rows stand
in the same order under names of their own. A value on a page must be what is computed to a tenth of
what the case allows: solvers that improve may change the digits behind. Cases that allow anything
are held to a tenth of a percent. Of cantilevers in large displacements the pages have the largest of
four loads alone.
"""

import re
import subprocess
import sys

ROW = re.compile(r"(.+?) +(\d+) +(\d+) +(\S+) +(\S+) +(\S+) +([+-]\S+) +(\S+)")
SMALLER_LOAD = re.compile(r"a = [125], ")
START, END = "<!-- tables -->", "<!-- end -->"


def compute(program):
    """[(title, source, [row, ...])] as `quoin-cli verify` prints them; a row is a list of strings."""
    text = subprocess.run([program, "verify", "-q"], capture_output=True, text=True, check=True).stdout
    groups = []
    for line in text.splitlines():
        if line.startswith(" " * 23):
            title, _, source = before.rpartition(" (")
            groups.append((title, source[:-1], []))
        row = ROW.match(line)
        if row and not SMALLER_LOAD.match(line):
            name, _, _, reference, _, found, error, allowed = row.groups()
            groups[-1][2].append([name.rstrip("‡"), reference, found, error, allowed])
        before = line
    return groups


def page_tables(groups):
    out = []
    for title, source, rows in groups:
        out += ["", f"## {title}", "", f"Reference: {source}.", "",
                "| case | reference | Quoin | error % |", "| --- | --- | --- | --- |"]
        out += ["| " + " | ".join(row[:4]) + " |" for row in rows]
    return "\n".join(out) + "\n\n"


def cells_of(line):
    """The cells of a row with numbers; none of another line."""
    cells = [cell.strip() for cell in line.strip("|").split("|")]
    numbers = line.startswith("| ") and len(cells) == 4 and re.fullmatch(r"[+-][0-9.]+", cells[3])
    return cells if numbers else None


def read_rows(text):
    rows = []
    for line in text.splitlines():
        if line.startswith("## "):
            title = line[3:]
        elif cells_of(line):
            rows.append([title] + cells_of(line))
    return rows


def renumbered(text, now):
    """A translation with the numbers of these rows, one after the other."""
    lines, left = [], [row[2:5] for row in now]
    for line in text.splitlines():
        cells = cells_of(line)
        lines.append("| " + " | ".join(cells[:1] + left.pop(0)) + " |" if cells else line)
    assert not left, "the translation has fewer rows"
    return "\n".join(lines) + "\n"


def differences(page, now, translated=False):
    first = 2 if translated else 0
    if [row[first:3] for row in page] != [row[first:3] for row in now]:
        yield "the cases are not those of the program"
        return
    for old, new in zip(page, now):
        allowed = float(new[5]) / 1000 if new[5] != "none" else 1e-3
        scale = max(abs(float(new[2])), 1e-6)
        if abs(float(old[3]) - float(new[3])) > max(allowed * scale, 2e-6):
            yield f"{new[0]}, {new[1]}: the page says {old[3]}, the program {new[3]}"


def main():
    check = sys.argv[1] == "--check"
    program, *paths = sys.argv[2 if check else 1:]
    groups = compute(program)
    tables = page_tables(groups)
    now = [[title] + row for title, _, rows in groups for row in rows]
    assert len(now) > 50
    found = []
    for path in paths:
        translated = path != paths[0]
        with open(path, encoding="utf-8") as file:
            before, _, rest = file.read().partition(START)
        old, _, after = rest.partition(END)
        if not check:
            new = renumbered(old, now).lstrip("\n") if translated else tables
            with open(path, "w", encoding="utf-8") as file:
                file.write(before + START + "\n" + ("\n" if translated else "") + new + END + after)
            continue
        page = read_rows(old)
        # A changed digit shows that the comparison can fail.
        changed = [row[:] for row in page]
        changed[0][3] = str(float(changed[0][3]) * 1.1)
        assert list(differences(changed, now, translated))
        found += [f"{path}: {what}" for what in differences(page, now, translated)]
    print("\n".join(found))
    sys.exit(1 if found else 0)


main()
