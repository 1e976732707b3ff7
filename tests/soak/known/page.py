# SPDX-License-Identifier: MIT
"""page.py --commit C --folder FOLDER PAGE: the counts of camopt_known, from its state files of this commit, written into docs/trials.md.

A table for the newest commit by class, answer and condition, and a line for each commit."""
import argparse
import collections
import re
from pathlib import Path

BEGIN, END = "<!-- known -->\n", "<!-- end of known -->"
JUDGEMENTS = ("right", "open", "wrong", "refused")
BANDS = ("1e0 … 1e2", "1e2 … 1e4", "1e4 … 1e6", "1e6 … 1e8", "1e8 and more")
KINDS = {"known": "inner", "edges": "edges"}


def counted(files):
    """{(kind, class, answer): Counter of BANDS and JUDGEMENTS}."""
    rows = collections.defaultdict(collections.Counter)
    for file in files:
        kind = KINDS[file.stem.split("_")[1]]
        for line in file.read_text().splitlines()[1:]:
            name, answer, band, *counts = line.split("\t")
            row = rows[kind, name, answer]
            for judgement, count in zip(JUDGEMENTS, map(int, counts)):
                row[judgement] += count
                row[band] += count
    return rows


def cells(values):
    return "| " + " | ".join(map(str, values)) + " |"


def order(name):
    """Powers of ten in their order."""
    return [float(part) if re.fullmatch(r"1e-\d+", part) else part for part in re.split(r"(1e-\d+)", name)]


def table(rows):
    lines = [cells(("scenes", "class", "answer") + BANDS + JUDGEMENTS), "|---|---|---|" + "--:|" * (len(BANDS) + len(JUDGEMENTS))]
    for kind in KINDS.values():
        own = {key: row for key, row in rows.items() if key[0] == kind}
        lines += [cells((kind, name, answer) + tuple(row[column] for column in BANDS + JUDGEMENTS))
                  for (_, name, answer), row in sorted(own.items(), key=lambda entry: (order(entry[0][1]), entry[0][2]))]
    total = sum(rows.values(), collections.Counter())
    return lines + [cells(("all", "all", "all") + tuple(total[column] for column in BANDS + JUDGEMENTS))]


def commits(text, commit, rows):
    """The line of this commit replaces the one that it has."""
    found = {name: tuple(map(int, counts)) for name, *counts in re.findall(r"^\| `(\w+)` \|" + r" (\d+) \|" * 5 + "$", text, re.M)}
    total = sum(rows.values(), collections.Counter())
    judged = tuple(total[name] for name in JUDGEMENTS)
    found.pop(commit, None)
    found[commit] = (sum(judged), *judged)
    return [cells(("commit", "scenes") + JUDGEMENTS), "|---|" + "--:|" * 5] + [cells((f"`{name}`",) + counts) for name, counts in found.items()]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path)
    parser.add_argument("--commit", required=True)
    parser.add_argument("--folder", type=Path, required=True)
    arguments = parser.parse_args()
    rows = counted(sorted(arguments.folder.glob(f"{arguments.commit}_*.tsv")))
    head, rest = arguments.page.read_text().split(BEGIN, 1)
    old, tail = rest.split(END, 1)
    text = "\n".join(table(rows) + [""] + commits(old, arguments.commit, rows)) + "\n"
    new = arguments.page.with_suffix(".new")
    new.write_text(head + BEGIN + text + END + tail)
    new.replace(arguments.page)


if __name__ == "__main__":
    main()
