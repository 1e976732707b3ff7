# SPDX-License-Identifier: MIT
"""tally.py --minutes M (--soak PROGRAM | --camopt PROGRAM …) [--seed S] [--page FILE] [--out FOLDER]: a part of the counted trials.

Adds to docs/trials.md, by commit: trials of camopt_soak (--soak), and random scenes of every class (checked_scenes.py) that camopt
solves and the exact checker judges (--camopt). The next part goes on with the numbers after those that are counted; the page is
written after every round, so a part that is interrupted loses the last round at most. Exit status 1 where something failed or a
verdict was refuted.
"""
import argparse
import collections
import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from checked_scenes import CLASSES, drawn

ROOT = Path(__file__).resolve().parents[2]
COLUMNS = ("scenes", "optimal", "infeasible", "other", "disagreements", "confirmed", "not judged", "refuted")
CHANGED = {"--motions": "changed motions", "--cams": "changed cams"}  # classes of camopt_soak, by its options
ROUND = {"--motions": 20, "--cams": 2}  # scenes
BEGIN, END = "<!-- trials -->\n", "<!-- end of trials -->"


class Page:
    """The table: {(commit, class): Counter of COLUMNS}."""

    def __init__(self, file):
        self.file, self.rows = file, {}
        for commit, kind, *cells in re.findall(r"^\| `(\w+)` \| ([^|]+) \|" + r" (\d+) \|" * len(COLUMNS) + "$", file.read_text(), re.M):
            self.rows[commit, kind] = collections.Counter(dict(zip(COLUMNS, map(int, cells))))

    def add(self, commit, kind, counts):
        self.rows[commit, kind] = self.rows.get((commit, kind), collections.Counter()) + collections.Counter(counts)
        lines = ["| commit | class | " + " | ".join(COLUMNS) + " |", "|---|---|" + "--:|" * len(COLUMNS)]
        lines += [f"| `{commit}` | {kind} | " + " | ".join(str(row[name]) for name in COLUMNS) + " |" for (commit, kind), row in self.rows.items()]
        total = sum(self.rows.values(), collections.Counter())
        lines.append("| all | all | " + " | ".join(str(total[name]) for name in COLUMNS) + " |")
        head, rest = self.file.read_text().split(BEGIN, 1)
        new = self.file.with_suffix(".new")
        new.write_text(head + BEGIN + "\n".join(lines) + "\n" + END + rest.split(END, 1)[1])
        new.replace(self.file)

    def next(self, commit, kind):
        return self.rows.get((commit, kind), {"scenes": 0})["scenes"]


def counts_of(report):
    """From the table that camopt_soak prints at its end; None: it was interrupted."""
    verdicts = re.search(r"^verdicts:(.*)$", report, re.M)
    total = re.search(r"^(\d+) trials, \d+ solves, \d+ s in them, (\d+) failures$", report, re.M)
    if not verdicts or not total:
        return None
    found = {name: int(count) for name, count in re.findall(r" ([\w ]+?) (\d+)", verdicts[1])}
    other = sum(found.values()) - found.get("optimal", 0) - found.get("infeasible", 0)
    return {"scenes": int(total[1]), "optimal": found.get("optimal", 0), "infeasible": found.get("infeasible", 0), "other": other,
            "disagreements": int(total[2])}


def changed_scenes(program, option, arguments, first):
    """One round of camopt_soak."""
    beside = next(other for other in CHANGED if other != option)
    command = [program, option, str(ROUND[option]), beside, "0", "--first", str(first), "--seed", str(arguments.seed), "--jobs", "2",
               "--out", arguments.out]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    print(run.stdout.rsplit("relation ", 1)[0], end="", flush=True)
    counts = counts_of(run.stdout)
    if counts is None:
        raise SystemExit(f"{program} ended with {run.returncode}: {run.stderr[-300:]}")
    return counts


def checked_scene(camopt, kind, arguments, number):
    """One scene, solved and judged by scripts/verify-certificate."""
    counts = {"scenes": 1}
    with tempfile.TemporaryDirectory() as place:
        scene, folder = Path(place) / "scene.toml", Path(place) / "result"
        scene.write_text(drawn(kind, arguments.seed, number))
        run = subprocess.run([camopt, "solve", str(scene), "--out", str(folder), "--set", "solver.max_seconds=20"], capture_output=True,
                             text=True, check=False)
        if run.returncode not in (0, 1, 3):
            outcome, why = "disagreements", f"camopt ended with {run.returncode}: {run.stderr.strip()}"
        else:
            verdict = json.loads((folder / "result.json").read_text())["verdict"]
            counts[verdict if verdict in COLUMNS else "other"] = 1
            outcome, why = judged(folder)
            if outcome == "not judged" and verdict not in ("optimal", "infeasible"):
                outcome = None
        if outcome:
            counts[outcome] = 1
        if outcome not in (None, "confirmed"):
            kept = Path(arguments.out) / "checked" / f"{kind.replace(' ', '_')}_{arguments.seed}_{number}.toml"
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_text(scene.read_text())
            print(f"{outcome}: {why}\n    {kept}", flush=True)
    return counts


def judged(folder):
    command = [sys.executable, "-B", str(ROOT / "scripts/verify-certificate"), str(folder), "--quiet"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    return {0: "confirmed", 2: "not judged"}.get(run.returncode, "refuted"), (run.stdout + run.stderr).strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--soak")
    parser.add_argument("--camopt")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--page", type=Path, default=ROOT / "docs/trials.md")
    parser.add_argument("--out", default=str(ROOT / "out/soak"))
    arguments = parser.parse_args()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
    page, end, failed = Page(arguments.page), time.monotonic() + 60 * arguments.minutes, 0
    rounds = [(kind, lambda n, option=option: changed_scenes(arguments.soak, option, arguments, n))
              for option, kind in CHANGED.items() if arguments.soak]
    rounds += [(kind, lambda n, kind=kind: checked_scene(arguments.camopt, kind, arguments, n)) for kind in CLASSES if arguments.camopt]
    rounds.sort(key=lambda own: page.next(commit, own[0]))  # a part that is short goes on with what had least
    while time.monotonic() < end:
        for kind, make in rounds:
            if time.monotonic() < end:
                counts = make(page.next(commit, kind))
                failed += counts.get("disagreements", 0) + counts.get("refuted", 0)
                page.add(commit, kind, counts)
    own = sum((row for (of, _), row in page.rows.items() if of == commit), collections.Counter())
    print(f"{commit}: " + ", ".join(f"{own[name]} {name}" for name in COLUMNS))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
