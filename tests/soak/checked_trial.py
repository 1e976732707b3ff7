# SPDX-License-Identifier: MIT
"""One random scene: solved, its proof judged by scripts/verify-certificate, its exports by scripts/verify-export."""
import collections
import json
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from checked_scenes import ATTEMPTS, DRAWN, drawn
from trials_page import reason_cell

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "tests/certificates"), str(ROOT / "tests/pairs")]
import checker  # noqa: E402
import pairs  # noqa: E402
import read_back  # noqa: E402

VERDICTS = ("optimal", "infeasible")
SOLVING, WAITING, JUDGING = 20, 300, 60  # seconds: camopt's own limit, the longest wait for it, and of the processor for a checker
FORMATS = {name: words for name, (command, words, _) in pairs.OUTPUTS.items() if command == "export"}
# Of the files of one export the worst counts.
OUTCOMES = ("read back", "confirmed", "in part", "not judged", "refused", "refuted")


class OutOfTime(Exception):
    pass


def out_of_time(*_):
    raise OutOfTime(f"no outcome within {JUDGING} s of the processor")


def is_known(name, why):
    """A reason for which pairs.py expects this export to be refused."""
    machines = [(words, [name], ()) for words in pairs.MACHINES_REFUSED.values()]
    return any(name in outputs and re.search(words, why) for words, outputs, _ in pairs.REFUSED + machines)


def in_time(judge, *arguments):
    """(exit code, why) of a checker in this process; one that ends otherwise confirms nothing."""
    before = signal.signal(signal.SIGVTALRM, out_of_time)
    signal.setitimer(signal.ITIMER_VIRTUAL, JUDGING)
    try:
        return judge(*arguments)
    except OutOfTime as late:
        return 2, str(late)
    except Exception as fault:  # pylint: disable=broad-except
        return 1, f"REFUTED: the checker ended with {type(fault).__name__}: {fault}"
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


class Judges:
    """Both checkers, loaded once."""

    def __init__(self):
        self.of_proofs, self.of_exports = checker.load(), checker.load_exports()

    def proof(self, folder):
        code, why = in_time(self.of_proofs.outcome_of, folder, checker.Silent(), None)
        return {0: "confirmed", 2: "not judged"}.get(code, "refuted"), why

    def export(self, file, scene):
        code, lines = in_time(self.of_exports.outcome_of, file, scene)
        why = lines if isinstance(lines, str) else lines[-1]
        return {0: "confirmed", 2: "in part" if "everything else is confirmed" in why else "not judged"}.get(code, "refuted"), why


class Trial:
    """What is counted of one scene: `counts`, `exports` {format: outcome} and `reasons` [(class or format, outcome, reason)]."""

    def __init__(self, camopt, judges, kept):
        self.camopt, self.judges, self.kept = camopt, judges, kept
        self.counts, self.exports, self.reasons = collections.Counter(scenes=1), {}, []

    def run(self, kind, seed, number, with_exports):
        self.kind, self.name = kind, f"{kind} {seed} {number}".replace(" ", "_")
        with tempfile.TemporaryDirectory() as place:
            self.place, self.result = Path(place), Path(place) / "result"
            outcome, why = self.solve(kind, seed, number)
            if outcome:
                self.counts[outcome] += 1
            if outcome not in (None, "confirmed"):
                self.note(kind, outcome, why, [self.place / name for name in self.files])
            if with_exports and self.verdict not in (None, "infeasible", "failed"):
                for name, words in FORMATS.items():
                    self.export(name, words)
        return self

    def note(self, what, outcome, why, files):
        """The reason, for the page; what shows a fault, or a refusal that no test expects, stays in a folder."""
        self.reasons.append((what, outcome, reason_cell(why)))
        if outcome == "in part" or (outcome == "refused" and (what == self.kind or is_known(what, why))):
            return
        folder = self.kept / (self.name if what == self.kind else f"{self.name} {what}".replace(" ", "_"))
        folder.mkdir(parents=True, exist_ok=True)
        for file in files:
            copy = shutil.copytree if file.is_dir() else shutil.copy
            copy(file, folder / file.name, **({"dirs_exist_ok": True} if file.is_dir() else {}))
        print(f"{what}: {outcome}: {why}\n    {folder}", flush=True)

    def command(self, *words):
        return subprocess.run([self.camopt, *map(str, words)], capture_output=True, text=True, timeout=WAITING, check=False)

    @property
    def is_machine(self):
        return "machine.toml" in self.files

    def solve(self, kind, seed, number):
        """(what is counted beside the verdict, why)."""
        self.verdict = None
        for attempt in range(1 if kind in DRAWN else ATTEMPTS):
            self.files = drawn(kind, seed, number, attempt)
            for name, text in self.files.items():
                (self.place / name).write_text(text)
            self.scene = self.place / next(iter(self.files))
            solve = ["machine", self.scene, "--max-seconds", SOLVING] if self.is_machine else \
                ["solve", self.scene, "--set", f"solver.max_seconds={SOLVING}"]
            try:
                done = self.command(*solve, "--out", self.result)
            except subprocess.TimeoutExpired as late:
                return "disagreements", str(late)
            if done.returncode != 2:
                break
        answer = self.result / ("machine.json" if self.is_machine else "result.json")
        if done.returncode not in (0, 1, 3) or not answer.exists():
            refused = done.returncode == 2 and kind not in DRAWN
            return "refused" if refused else "disagreements", f"camopt ended with {done.returncode}: {done.stderr.strip()}"
        answer = json.loads(answer.read_text())
        self.verdict, self.speed = answer["verdict"], answer.get("speed_rpm")
        self.counts[self.verdict if self.verdict in VERDICTS else "other"] += 1
        outcome, why = self.judges.proof(self.result)
        return (None if outcome == "not judged" and self.verdict not in VERDICTS else outcome), why

    def export(self, name, words):
        """A machine has electronic cams alone, one of each axis, and they are written where it is solved: at a speed that leaves room."""
        out = self.place / "exported"
        shutil.rmtree(out, ignore_errors=True)
        if self.is_machine:
            if "--plc" not in words:
                return
            call = ["machine", self.scene, "--max-seconds", SOLVING, "--set", f"machine.speed_rpm={0.9 * self.speed:.6g}", *words[1:]]
        else:
            call = ["export", *({"RESULT": self.result}.get(word, word) for word in words)]
        try:
            done = self.command(*call, "--out", out)
            outcome, why = self.refusal(done, out) if done.returncode else self.judged(out)
        except subprocess.TimeoutExpired:
            outcome, why = "refuted", f"no export within {WAITING} s"
        self.exports[name] = outcome
        if outcome not in ("confirmed", "read back"):
            self.note(name, outcome, why, [self.place / name for name in self.files] + [folder for folder in (self.result, out) if folder.exists()])

    @staticmethod
    def refusal(done, out):
        """A refused export is none: a reason is given, and no file is left."""
        why = done.stderr.strip()
        if done.returncode in (1, 2, 3) and why and not any(out.glob("**/*.*")):
            return "refused", why
        return "refuted", f"camopt ended with {done.returncode}: {why}"

    def judged(self, out):
        """The worst outcome of the files in a folder, or in those of the axes of a machine."""
        found = [("refuted", "nothing was written")] if not any(out.glob("**/*.*")) else [("read back", "")]
        for folder in (axis.parent for axis in out.glob("*/scene.toml")) if self.is_machine else [out]:
            result = folder if self.is_machine else self.result
            found += [self.judges.export(file, result / "scene.toml") for file in self.judges.of_exports.claimed(folder)]
            found += [self.read(path, result) for path in sorted(folder.glob("*.*"))]
        return max(found, key=lambda one: OUTCOMES.index(one[0]))

    @staticmethod
    def read(path, result):
        try:
            read_back.read(path, result)
            return "read back", ""
        except Exception as fault:  # pylint: disable=broad-except
            return "refuted", f"{path.name} is broken: {type(fault).__name__}: {fault}"
