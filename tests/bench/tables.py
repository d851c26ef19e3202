#!/usr/bin/env python3
"""Tables of the benchmark programs: compared with earlier ones, and shown in a document.

tables.py compare [--partial] BASELINE FRESH   what got worse; --partial: not all was run
tables.py show [--check] FOLDER TEXT.md        writes the tables of the text anew

The heading of a column says what it holds and when it got worse:
  … outcome         from an answer to none, or to another one
  … factorisations  larger at all
  … multiplier      lower by more than 1e-3 or twice the row's tolerance, in rows without an error;
                    "limit multiplier", which is exact: different by 1e-6
  error …           %: farther from zero by that margin
  …/kernel          more than 1.6 times as long, from 0.3 kernels on; a whole table: 1.25 times in
                    the geometric mean
  met               "yes" that became "no"
What a time limit stopped is not compared, and no other column.

A table of the text stands between "<!-- table NAME [where heading is value, …]: heading |
heading = title | … -->" and "<!-- end -->". Exit codes: 0 done, 1 worse or another text, 2 wrong
usage or files."""
import csv, math, pathlib, re, sys

KEYS = {"walls": 6, "members": 4, "joints": 4, "contacts": 2, "render": 2, "scaling": 2, "paths": 3,
        "scaling-bars": 2, "contacts-bars": 2}


def read(folder, name):
    with open(pathlib.Path(folder, name + ".csv"), encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return math.nan


def is_answer(outcome):
    return outcome not in ("", "cancelled", "not-converged")


def outcome_of(row, heading):
    return row.get(re.split("[ /]", heading)[0] + " outcome", row.get("outcome"))


def verdict(heading, old, new, times):
    """1: worse, -1: better, 0: as good, None: not compared."""
    a, b = old[heading], new[heading]
    if heading == "met":
        return (a == "yes") - (b == "yes")
    if heading.endswith("outcome"):
        return 0 if a == b else 1 if is_answer(a) or not is_answer(b) else -1
    if any(o is not None and not is_answer(o) for o in (outcome_of(old, heading), outcome_of(new, heading))):
        return None
    a, b = number(a), number(b)
    margin = max(1e-3, 2 * number(old.get("tolerance", 0)))
    if math.isnan(a):
        return None
    if math.isnan(b):
        return 1
    if heading.endswith("factorisations"):
        return (b > a) - (b < a)
    if heading == "limit multiplier":
        return int(abs(b - a) > 1e-6 * (1 + abs(a)))
    if heading.endswith("multiplier"):
        if any(h.startswith("error") and not math.isnan(number(v)) for h, v in old.items()):
            return None
        return (b < a - margin * abs(a)) - (a < b - margin * abs(a))
    if heading.startswith("error"):
        return (abs(b) > abs(a) + 100 * margin) - (abs(a) > abs(b) + 100 * margin)
    if heading.endswith("/kernel"):
        a, b = max(a, 0.3), max(b, 0.3)
        if (a, b) == (0.3, 0.3):
            return 0
        times.append(math.log(b / a))
        return (b > 1.6 * a) - (a > 1.6 * b)
    return None


def compare(baseline, fresh, partial):
    worse = found = 0
    for name, count in KEYS.items():
        if not pathlib.Path(baseline, name + ".csv").exists() or (
                partial and not pathlib.Path(fresh, name + ".csv").exists()):
            continue
        found += 1
        before, after, times, table_worse, figures = read(baseline, name), {}, [], 0, 0
        for row in read(fresh, name):
            after[tuple(row.values())[:count]] = row
        for old in before:
            key = tuple(old.values())[:count]
            new = after.get(key)
            if new is None and not partial:
                print(f"  missing {name} {' '.join(key)}")
                table_worse += 1
            for heading in list(old)[count:] if new else []:
                said = verdict(heading, old, new, times) if heading in new else None
                figures += said is not None
                if said:
                    table_worse += said > 0
                    print(f"  {'WORSE ' if said > 0 else 'better'} {name} {' '.join(filter(None, key))}: "
                          f"{heading} {old[heading]} -> {new[heading]}")
        mean = math.exp(sum(times) / len(times)) if len(times) > 1 else 1
        table_worse += mean > 1.25
        worse += table_worse
        print(f"{name:18} {figures:5} figures, times x {mean:.2f}, {table_worse} worse")
    if not found:
        sys.exit(f"tables: {baseline}, {fresh}: no table in both")
    return worse > 0


def show(folder, path, check):
    def table(match):
        request, columns = match[1].split(": ", 1)
        name, _, conditions = request.partition(" where ")
        rows = read(folder, name)
        for condition in filter(None, conditions.split(", ")):
            heading, value = condition.split(" is ")
            rows = [row for row in rows if row[heading] == value]
        pairs = [(c.split(" = ") * 2)[:2] for c in columns.split(" | ")]
        lines = ["".join(f"| {title} " for _, title in pairs) + "|", "| --- " * len(pairs) + "|"]
        for row in rows:
            lines.append("".join("| %s " % re.sub("^[+]?nan$", "–", row[h]) for h, _ in pairs) + "|")
        return f"<!-- table {match[1]} -->\n" + "\n".join(lines) + "\n<!-- end -->"

    text = pathlib.Path(path).read_text(encoding="utf-8")
    written = re.sub("<!-- table (.*?) -->\n.*?<!-- end -->", table, text, flags=re.S)
    if check and written != text:
        print(f"tables: {path} does not show the tables of {folder}", file=sys.stderr)
    elif not check:
        pathlib.Path(path).write_text(written, encoding="utf-8")
    return check and written != text


if __name__ == "__main__":
    options = [word for word in sys.argv[2:] if word.startswith("--")]
    words = [word for word in sys.argv[2:] if not word.startswith("--")]
    if len(words) != 2 or sys.argv[1] not in ("compare", "show") or set(options) - {"--partial", "--check"}:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    try:
        run = compare if sys.argv[1] == "compare" else show
        sys.exit(run(*words, bool(options)))
    except (OSError, KeyError, ValueError) as error:
        print(f"tables: {error!r}", file=sys.stderr)
        sys.exit(2)
