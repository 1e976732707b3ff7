# SPDX-License-Identifier: MIT
"""tally.py --minutes M (--soak PROGRAM | --camopt PROGRAM …) [--exports] [--only CLASS …] [--seed S] [--commit C] [--page FILE]
[--out FOLDER]: a part of the counted trials.

Adds to docs/trials.md, by commit: trials of camopt_soak (--soak), and random scenes of every class (checked_scenes.py) that camopt
solves and the exact checker judges (--camopt). --exports: each of them is also exported in every format, and what is written is
judged. The next part goes on with the numbers after those that are counted; the page is written after every round, so a part that is
interrupted loses the last round at most, and several parts of other classes may run at a time. Exit status 1 where something failed or
was refuted, 130 where it was interrupted.
"""
import argparse
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

from checked_scenes import CLASSES
from checked_trial import OUTCOMES, ROOT, Judges, Trial
from trials_page import Page, Table

COLUMNS = ("scenes", "optimal", "infeasible", "other", "disagreements", "confirmed", "not judged", "refuted", "refused")
CHANGED = {"--motions": "changed motions", "--cams": "changed cams"}  # classes of camopt_soak, by its options
ROUND = {"--motions": 20, "--cams": 2}  # scenes


class Trials(Page):
    def __init__(self, file):
        self.scenes = Table("trials", ("commit", "class"), COLUMNS)
        self.exports = Table("exports", ("commit", "format"), ("exports", *OUTCOMES))
        self.reasons = Table("reasons", ("class or format", "outcome", "reason"), ("times",))
        super().__init__(file, (self.scenes, self.exports, self.reasons))

    def next(self, commit, kind):
        return self.scenes.rows.get((commit, kind), {"scenes": 0})["scenes"]

    def add(self, commit, kind, counts, exports=None, reasons=()):
        with self.added_to():
            self.scenes.add((commit, kind), counts)
            for name, outcome in (exports or {}).items():
                self.exports.add((commit, name), {"exports": 1, outcome: 1})
            for reason in reasons:
                self.reasons.add(reason, {"times": 1})


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


def changed_scenes(page, option, arguments):
    """One round of camopt_soak; how often it failed."""
    kind, beside = CHANGED[option], next(other for other in CHANGED if other != option)
    command = [arguments.soak, option, str(ROUND[option]), beside, "0", "--first", str(page.next(arguments.commit, kind)),
               "--seed", str(arguments.seed), "--jobs", "2", "--out", str(arguments.out)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    print(run.stdout.rsplit("relation ", 1)[0], end="", flush=True)
    counts = counts_of(run.stdout)
    if counts is None:
        raise SystemExit(f"{arguments.soak} ended with {run.returncode}: {run.stderr[-300:]}")
    page.add(arguments.commit, kind, counts)
    return counts["disagreements"]


def checked_scene(page, kind, judges, arguments):
    """One scene of a class; how often it failed."""
    trial = Trial(arguments.camopt, judges, arguments.out / "checked")
    trial.run(kind, arguments.seed, page.next(arguments.commit, kind), arguments.exports)
    page.add(arguments.commit, kind, trial.counts, trial.exports, trial.reasons)
    return trial.counts["disagreements"] + trial.counts["refuted"] + list(trial.exports.values()).count("refuted")


def part(page, arguments):
    """Until the time is over; a part that is short goes on with what had least."""
    end, failed = time.monotonic() + 60 * arguments.minutes, 0
    judges = Judges()
    rounds = {CHANGED[option]: lambda kind, option=option: changed_scenes(page, option, arguments) for option in CHANGED if arguments.soak}
    rounds |= {kind: lambda kind: checked_scene(page, kind, judges, arguments) for kind in CLASSES if arguments.camopt}
    chosen = arguments.only or sorted(rounds, key=lambda kind: page.next(arguments.commit, kind))
    while time.monotonic() < end:
        for kind in chosen:
            if time.monotonic() < end:
                failed += rounds[kind](kind)
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--soak")
    parser.add_argument("--camopt")
    parser.add_argument("--exports", action="store_true", help="of the scenes that --camopt solves")
    parser.add_argument("--only", action="append", choices=[*CHANGED.values(), *CLASSES], metavar="CLASS")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--commit", help="of the programs; default: HEAD")
    parser.add_argument("--page", type=Path, default=ROOT / "docs/trials.md")
    parser.add_argument("--out", type=Path, default=ROOT / "out/soak")
    arguments = parser.parse_args()
    arguments.commit = arguments.commit or subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True,
                                                          check=True).stdout.strip()
    page = Trials(arguments.page)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        status = 1 if part(page, arguments) else 0
    except KeyboardInterrupt:
        status = 130
    print(f"{arguments.commit}: {page.scenes.sum_of(arguments.commit)}")
    if arguments.exports:
        print(f"{arguments.commit}: {page.exports.sum_of(arguments.commit)}")
    return status


if __name__ == "__main__":
    sys.exit(main())
