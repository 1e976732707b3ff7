#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Changes one operator or number of the production code at a time and asks whether a test notices.

    tests/mutation/mutate.py --work DIR [--seed 1] [--count 200] [--folders profiles,objectives,solvers,studies]

Works on a copy of the tracked files in DIR, built there with the preset `release`. A mutant is tried against
the tests of its own folder and of the folders above it in the data flow, quickest programs first; tests that
take longer than --slow seconds unmutated are left out, and listed. It is *killed* where a test fails, crashes
or runs out of processor time, *stillborn* where it does not compile, and *alive* where nobody noticed. The list
(DIR/mutants.csv) is written line by line; a second call goes on where the first ended. Exit status 1 where a
mutant is alive that tests/mutation/explained.txt does not explain.

--together compiles all mutants at once, each switched on by a number (switched.py), and the few that cannot be
switched by themselves: minutes instead of hours.

--again FILE tries the mutants that another run's list calls alive, found again by their lines' text.

Left alone: comments, strings, preprocessor lines, asserts, and named constants (`constexpr`): a tolerance that
is a thousandth larger is another choice, not a fault.
"""
import argparse
import csv
import json
import math
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from switched import Switched

ROOT = Path(__file__).resolve().parents[2]
EXPLAINED = ROOT / "tests/mutation/explained.txt"

# Which test folders speak of a production folder: its own, then those above in the data flow.
ABOVE = {
    "profiles": ["profiles", "objectives", "studies", "report", "shop"],
    "objectives": ["objectives", "studies", "report", "shop"],
    "solvers": ["solvers", "objectives", "studies", "report", "shop"],
    "studies": ["studies", "report", "shop"],
    "splines": ["splines", "objectives", "studies", "report", "shop"],
    "motions": ["motions", "objectives", "studies", "report", "shop"],
    "core": ["core", "profiles", "objectives", "studies", "report", "shop"],
}

SWAPS = [
    (" + ", " - "), (" - ", " + "), (" * ", " / "), (" / ", " * "), (" += ", " -= "), (" -= ", " += "),
    (" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" < ", " > "), (" > ", " < "),
    (" == ", " != "), (" != ", " == "), (" && ", " || "), (" || ", " && "),
    ("std::min(", "std::max("), ("std::max(", "std::min("), ("std::sin(", "std::cos("), ("std::cos(", "std::sin("),
    ("return -", "return "), ("= -", "= "), ("true", "false"), ("false", "true"), ("(!", "("),
]
NUMBER = re.compile(r"(?<![\w.])(\d+\.\d+(?:e[+-]?\d+)?)(?![\w.])")
SKIPPED_LINE = re.compile(r"^\s*(#|template|using |static_assert|constexpr|inline constexpr|static constexpr|namespace|//)")
# Members that have a value before they get theirs.
DEFAULT_MEMBER = re.compile(r"^\s*(double|int|bool|std::\w+(<.*>)?|\w+)\s[^()]*;")


def blanked(text):
    """The text with comments and literals replaced by spaces, places kept."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
    return pattern.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def sites_of(path):
    """Every (offset, old, new) that may be changed in a file."""
    text = path.read_text()
    code = blanked(text)
    found, start = [], 0
    for line in code.splitlines(keepends=True):
        member = path.suffix == ".hpp" and DEFAULT_MEMBER.match(line) and "return" not in line
        if not SKIPPED_LINE.match(line) and not member:
            for old, new in SWAPS:
                found += [(start + at.start(), old, new) for at in re.finditer(re.escape(old), line)]
            for number in NUMBER.finditer(line):
                value = float(number.group(1))
                changed = "0.001" if value == 0.0 else repr(value * 1.001)
                found.append((start + number.start(1), number.group(1), changed))
        start += len(line)
    return found


def chosen_mutants(copy, folders, count, seed):
    """As many of each folder, drawn without repetition."""
    generator = random.Random(seed)
    mutants = []
    for index, folder in enumerate(folders):
        share = count // len(folders) + (index < count % len(folders))
        sites = [(path.relative_to(copy), *site)
                 for path in sorted((copy / folder).rglob("*"))
                 if path.suffix in (".cpp", ".hpp") and "absent" not in path.name
                 for site in sites_of(path)]
        mutants += [(folder, *site) for site in generator.sample(sites, min(share, len(sites)))]
    return mutants


def mutants_alive(copy, table):
    """The alive ones of an earlier list where the same change can still be made."""
    mutants = []
    for _, verdict, name, _, old, new, text, _ in csv.reader(table.open()):
        if verdict != "alive":
            continue
        code = (copy / name).read_text() if (copy / name).exists() else ""
        lines = code.splitlines()
        same = [site for site in (sites_of(copy / name) if code else [])
                if site[1].strip() == old and site[2].strip() == new
                and lines[code.count("\n", 0, site[0])].strip() == text]
        if same:
            mutants.append((name.split("/")[0], Path(name), *same[0]))
        else:
            print(f"gone: {name}: {text}")
    return mutants


def run(command, folder, seconds=None, number=0):
    """(exit status, output); no status where it ran out of time. number: of the mutant that is switched on.

    Of processor time: on a loaded or halted machine a test must not pass for one that hangs. What sleeps for
    good ends by the clock.
    """
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(seconds), math.ceil(seconds) + 5))
    try:
        done = subprocess.run(command, cwd=folder, timeout=seconds and 20.0 * seconds, capture_output=True, text=True,
                              errors="replace", preexec_fn=limit if seconds else None,
                              env=os.environ | {"CAMOPT_MUTANT": str(number)})
    except subprocess.TimeoutExpired:
        return None, ""
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return None, ""
    return done.returncode, done.stdout + done.stderr


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Tests:
    """The test programs of a build, how long each takes and what of it is too slow to ask two hundred times."""

    def __init__(self, copy, slow, jobs):
        self.copy, self.build, self.slow, self.jobs = copy, copy / "build/release", slow, jobs
        self.programs = {}  # folder of tests -> [(seconds, target, filter)]
        self.left_out = []
        self.kept = copy.parent / "measured.json"
        if self.kept.exists() and (known := json.loads(self.kept.read_text()))["slow"] == slow:
            self.programs, self.left_out = known["programs"], known["left_out"]

    def knows(self, folder):
        return folder in self.programs

    def measure(self, folder):
        """Builds and times the programs of a folder; no mutant may be at work. Kept for the next call."""
        found = []
        for target in self.targets(folder):
            status, output = self.compile(target)
            if status != 0:
                sys.exit(f"{target} does not build unmutated:\n{output[-3000:]}")
            found.append(self.measured(target, self.program(target)))
        self.programs[folder] = sorted(found)
        self.kept.write_text(json.dumps({"slow": self.slow, "programs": self.programs,
                                         "left_out": self.left_out}))

    def targets(self, folder):
        status, output = run(["ninja", "-t", "targets", "all"], self.build)
        return sorted(set(re.findall(rf"^tests/{folder}/(?:\S+/)?(\w+_test): CXX_EXECUTABLE_LINKER", output, re.M)))

    def program(self, target):
        return next(path for path in (self.build / "tests").rglob(target) if path.is_file())

    def compile(self, target):
        return run(["ninja", f"-j{self.jobs}", target], self.build)

    def measured(self, target, program):
        report = self.build / "unmutated.json"
        started, begun = processor_seconds(), time.monotonic()
        status, output = run([program, f"--gtest_output=json:{report}"], program.parent, 1800)
        seconds = processor_seconds() - started
        share = min(1.0, seconds / (time.monotonic() - begun))  # of a processor, on a machine that is not idle
        names, slow_seconds = [], 0.0
        if status != 0:
            # A machine that is busy may make a test fail that has a time limit: it tells nothing then.
            names = sorted(set(re.findall(r"\[  FAILED  \] ([^\s,]+)", output)))
            if not names:
                sys.exit(f"{target} fails unmutated:\n{output[-3000:]}")
        for suite in json.loads(report.read_text())["testsuites"]:
            for test in suite["testsuite"]:
                own = share * float(test["time"].rstrip("s"))
                if own > self.slow:
                    names.append(f"{suite['name']}.{test['name']}")
                    slow_seconds += own
        names = sorted(set(names))
        self.left_out += [f"{target}: {name}" for name in names]
        return max(0.0, seconds - slow_seconds), target, "-" + ":".join(names) if names else "*"

    def verdict(self, folder):
        """Who killed the mutant that the copy holds now; "unknown" and a folder that is to be measured first."""
        for above in ABOVE[folder]:
            if not self.knows(above):
                return "unknown", above
            for seconds, target, pattern in self.programs[above]:
                status, output = self.compile(target)
                if status != 0:
                    return "stillborn", target
                killer = self.killer(self.program(target), pattern, 60.0 + 10.0 * seconds, 0)
                if killer:
                    return "killed", f"{target}: {killer}"
        return "alive", ""

    def killer_in(self, folder, path, number):
        """Which test of a folder notices a mutant that is compiled already and only switched on; "": none.

        First those whose name says that they are about the mutant's room or file.
        """
        words = {*path.parts[1:-1], path.stem}
        for seconds, target, pattern in sorted(
                self.programs[folder], key=lambda program: not any(word in program[1] for word in words)):
            killer = self.killer(self.program(target), pattern, 60.0 + 10.0 * seconds, number)
            if killer:
                return f"{target}: {killer}"
        return ""

    def killer(self, program, pattern, seconds, number):
        """The first test that fails, and fails again by itself: once may be the machine's doing."""
        while True:
            status, output = run([program, "--gtest_fail_fast", f"--gtest_filter={pattern}"], program.parent, seconds,
                                 number)
            if status == 0:
                return ""
            failed = re.search(r"\[  FAILED  \] (\S+?),?\s", output)
            if not failed:
                return "timeout" if status is None else f"status {status}"
            name = failed.group(1)
            status, _ = run([program, f"--gtest_filter={name}"], program.parent, seconds, number)
            if status != 0:
                return name
            pattern = f"-{name}" if pattern == "*" else f"{pattern}:{name}"


def make_copy(work, shared):
    copy = work / "source"
    if not copy.exists():
        for name in subprocess.check_output(["git", "ls-files"], cwd=ROOT, text=True).splitlines():
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, copy / name)
    # Shared libraries: a mutant costs one compilation and one small link, and not a link for each program.
    status, output = run(["cmake", "--preset", "release", f"-DBUILD_SHARED_LIBS={'ON' if shared else 'OFF'}",
                          "-DCMAKE_LINK_DEPENDS_NO_SHARED=ON"], copy)
    if status != 0:
        sys.exit(output)
    return copy


class Together:
    """Mutants in one build. Each test folder is built when it is first asked, so that the quick ones answer first."""

    def __init__(self, tests, mutants):
        self.tests, self.mutants = tests, mutants
        self.switched = Switched(tests.copy, mutants, blanked)
        self.built = set()

    def build(self, targets):
        while True:
            self.switched.write()
            status, output = run(["ninja", "-k0", f"-j{self.tests.jobs}", *targets], self.tests.build)
            if status == 0:
                return
            blamed = self.switched.blamed(output)
            if not blamed:
                sys.exit(f"the mutants do not build together:\n{output[-6000:]}")
            for number in blamed:
                self.switched.next_way(number)
            print("another way for", *blamed, flush=True)

    def try_all(self, tell):
        """Tells the verdicts by number: of all in their own folder's tests, then of those left in the others'."""
        try:
            folder_of = {number: str(path).split("/")[0] for number, (path, *_) in self.mutants.items()}
            left = dict.fromkeys(self.mutants)  # those that nobody noticed yet
            for depth in range(max(map(len, ABOVE.values()))):
                for folder in dict.fromkeys(folder_of.values()):
                    own = [number for number in left if folder_of[number] == folder]
                    if own and depth < len(ABOVE[folder]):
                        self.try_folder(own, ABOVE[folder][depth], left, tell)
            for number in left:
                if self.switched.way[number] != "alone":
                    tell(number, "alive", "")
        finally:
            self.switched.restore()

    def try_folder(self, numbers, folder, left, tell):
        if folder not in self.built:
            self.build(self.tests.targets(folder))
            if not self.tests.knows(folder):
                self.tests.measure(folder)
            self.built.add(folder)
        for number in numbers:
            if self.switched.way[number] == "alone":
                continue
            killer = self.tests.killer_in(folder, self.mutants[number][0], number)
            if killer:
                del left[number]
                tell(number, "killed", killer)


def explained():
    """file: text of the line -> reason, for mutants that change nothing anyone could notice."""
    if not EXPLAINED.exists():
        return set()
    lines = [line for line in EXPLAINED.read_text().splitlines() if line and not line.startswith("#")]
    return {tuple(part.strip() for part in line.split(" | ")[:4]) for line in lines}  # "||" is part of a text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, required=True, help="a folder of its own; the copy is kept there")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--folders", default="profiles,objectives,solvers,studies")
    parser.add_argument("--slow", type=float, default=3.0, help="seconds: tests above this are left out")
    parser.add_argument("--again", type=Path, help="mutants.csv of an earlier run")
    parser.add_argument("--together", action="store_true", help="all mutants in one build")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # by way of finally: the copy is left unmutated
    folders = options.folders.split(",")
    copy = make_copy(options.work.resolve(), not options.together)
    mutants = (mutants_alive(copy, options.again) if options.again
               else chosen_mutants(copy, folders, options.count, options.seed))
    tests = Tests(copy, options.slow, options.jobs)

    table = options.work / "mutants.csv"
    done = list(csv.reader(table.open())) if table.exists() else []
    tried = {int(row[0]) for row in done}
    originals = {path: (copy / path).read_text() for _, path, *_ in mutants}
    with table.open("a", newline="") as file:
        writer = csv.writer(file)

        def tell(index, verdict, by):
            _, path, offset, old, new = mutants[index]
            line = originals[path].count("\n", 0, offset) + 1
            text = originals[path].splitlines()[line - 1].strip()
            row = [str(index), verdict, str(path), str(line), old.strip(), new.strip(), text, by]
            writer.writerow(row)
            file.flush()
            done.append(row)
            tried.add(index)
            print(f"{index + 1:4} of {len(mutants)}  {verdict:9}  {path}:{line}  {old.strip()} -> {new.strip()}  {by}",
                  flush=True)

        if options.together:
            left = {index + 1: mutant[1:] for index, mutant in enumerate(mutants) if index not in tried}
            Together(tests, left).try_all(lambda number, verdict, by: tell(number - 1, verdict, by))
        for index, (folder, path, offset, old, new) in enumerate(mutants):
            if index in tried:
                continue
            verdict, by = "unknown", folder
            while verdict == "unknown":
                if not tests.knows(by):
                    tests.measure(by)
                (copy / path).write_text(originals[path][:offset] + new + originals[path][offset + len(old):])
                try:
                    verdict, by = tests.verdict(folder)
                finally:
                    (copy / path).write_text(originals[path])
            tell(index, verdict, by)
        (options.work / "left_out.txt").write_text("\n".join(tests.left_out) + "\n")

    count = {verdict: sum(row[1] == verdict for row in done) for verdict in ("killed", "stillborn", "alive")}
    known = explained()
    open_rows = [row for row in done if row[1] == "alive" and (row[2], row[6], row[4], row[5]) not in known]
    print(f"\n{count['killed']} killed, {count['stillborn']} stillborn, {count['alive']} alive, "
          f"{len(open_rows)} of them unexplained")
    for row in open_rows:
        print(f"  {row[2]}:{row[3]}  {row[4]} -> {row[5]}    {row[6]}")
    sys.exit(1 if open_rows else 0)


if __name__ == "__main__":
    main()
