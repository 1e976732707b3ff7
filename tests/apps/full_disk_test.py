# SPDX-License-Identifier: MIT
"""full_disk_test.py PROGRAM SCENES FOLDER [--studio]: no command ends in exit code 0 where its output was cut short.

Standard output is /dev/full: exit code 1 and the reason, of every command and of every form it prints. Files meet a
limit of the process on the size of files, which a write meets as it meets a full disk: exit code 2 and the reason, and
a folder as it was before.

The commands in the table are held against those that `camopt --help` names: a new one has to be added here."""

import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys

PROGRAM, SCENES, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
STUDIO = "--studio" in sys.argv[4:]
MACHINE = SCENES / "machines/cartoner.toml"
DRD, CAM, DRUM, SLIDE = (SCENES / f"{name}.toml" for name in
                         ("drd_cubic_12", "cam_roller", "cylinder_slide", "dynamics_fast_slide"))
INTAKE, EXHAUST = SCENES / "valve_intake.toml", SCENES / "valve_exhaust.toml"
CHECKER = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "verify-certificate"
NO_SPACE = "camopt: cannot write to standard output: No space left on device\n"

SOLVED, SWEPT, SURFACE = FOLDER / "solved", FOLDER / "swept", FOLDER / "surface"
QUICK_TRAIN = ("--set", "spline.segments=8", "--speeds", "600:1200:3")

# What prints. Of a command that takes `--json` both forms.
PRINTING = [
    ("--help",), ("--version",), ("solve", "--help"), ("__manual",), ("__complete", ""),
    ("solve", DRD), ("solve", DRD, "--json"),
    ("compare", DRD), ("compare", DRD, "--json"),
    ("dynamics", SLIDE, *QUICK_TRAIN), ("dynamics", SLIDE, *QUICK_TRAIN, "--json"),
    ("machine", MACHINE), ("machine", MACHINE, "--json"),
    ("check", DRD),
    *(("list", topic, *form) for topic in ("laws", "followers", "solvers", "keys", "columns", "controllers")
      for form in ((), ("--json",))),
    ("table", "spline-vs-modified-sine"), ("table", "spline-vs-modified-sine", "--json"),
    ("report", SOLVED),
    ("export", SOLVED, "--out", FOLDER / "unused", "--csv"),
    ("inspect", SOLVED, SOLVED / "motion.csv"), ("inspect", SOLVED, SOLVED / "motion.csv", "--json"),
    ("valves", INTAKE, EXHAUST), ("valves", INTAKE, EXHAUST, "--json"),
    ("sweep", DRD, "--weights", "simplex:2", "--out", FOLDER / "unused_sweep"),
    ("sweep", DRD, "--pareto", "velocity,acceleration", "--points", "3", "--out", FOLDER / "unused_front"),
    ("sweep", DRD, "--surface", "0.1", "--out", FOLDER / "unused_surface"),
    ("sweep", SURFACE, "--at", "0.4,0.4,0.2"),
    ("sweep", "merge", SWEPT / "1", SWEPT / "2", "--out", FOLDER / "unused_merge"),
    *([("studio", DRD)] if STUDIO else []),
]

# What writes files into a folder, whose name comes last.
WRITING = [
    ("solve", CAM, "--out"),
    ("solve", DRUM, "--out"),
    ("compare", DRD, "--out"),
    ("dynamics", SLIDE, *QUICK_TRAIN, "--out"),
    ("inspect", SOLVED, SOLVED / "motion.csv", "--out"),
    ("valves", INTAKE, EXHAUST, "--out"),
    ("table", "spline-vs-modified-sine", "--out"),
    ("export", SOLVED, "--csv", "--dxf", "--drawing", "svg", "--stl", "--picture", "--plc", "csv", "--nc", "--out"),
    ("export", DRUM, "--csv", "--stl", "--picture", "--nc", "--out"),
    ("sweep", DRD, "--weights", "simplex:3", "--out"),
    ("sweep", DRD, "--pareto", "velocity,acceleration", "--points", "3", "--out"),
    ("sweep", DRD, "--surface", "0.1", "--out"),
    ("sweep", "merge", SWEPT / "1", SWEPT / "2", "--out"),
]
OPTIONAL = (("export", SOLVED, "--step", "--out"), ("export", DRUM, "--step", "--out"),
            ("export", SOLVED, "--drawing", "pdf", "--out"))  # libraries that a build may lack


def run(*words, **options):
    options = {"stdout": subprocess.PIPE, **options}
    return subprocess.run([PROGRAM, *map(str, words)], stderr=subprocess.PIPE, text=True, timeout=120, check=False,
                          **options)


def limited(size):
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return {"preexec_fn": limit, "restore_signals": False}


def contents(folder):
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


def commands_of_help():
    text = run("--help").stdout
    return re.findall(r"^  ([a-z]+) ", text[text.index("Subcommands:"):text.index("Examples:")], re.MULTILINE)


def print_to_a_full_disk():
    with open("/dev/full", "w", encoding="utf-8") as full:
        for words in PRINTING:
            printed = run(*words, stdout=full)
            assert (printed.returncode, printed.stderr) == (1, NO_SPACE), (words, printed.returncode, printed.stderr)
    closed = run("list", "laws", stdout=None, preexec_fn=lambda: os.close(1))
    assert closed.returncode == 1 and "cannot write to standard output" in closed.stderr, closed
    missing = set(commands_of_help()) - {words[0] for words in PRINTING} - (set() if STUDIO else {"studio"})
    assert not missing, f"commands without a row here: {missing}"


def check_to_a_full_disk():
    assert run("solve", DRD, "--out", FOLDER / "checked").returncode == 0
    with open("/dev/full", "w", encoding="utf-8") as full:
        checked = subprocess.run([sys.executable, "-B", CHECKER, FOLDER / "checked"], stdout=full, stderr=subprocess.PIPE,
                                 text=True, timeout=120, check=False)
    assert (checked.returncode, checked.stderr) == (2, "verify-certificate: cannot write: No space left on device\n"), checked


def leaves_the_folder(words):
    """A little less than its largest file needs (seconds in it may have a digit less): only the end does not go."""
    whole, cut = FOLDER / "whole", FOLDER / "cut"
    for folder in (whole, cut):
        shutil.rmtree(folder, ignore_errors=True)
    first = run(*words, whole)
    assert first.returncode == 0, (words, first.stderr)
    size = max(map(len, contents(whole).values())) * 99 // 100
    refused = run(*words, cut, **limited(size))
    assert refused.returncode == 2, (words, refused.returncode, refused.stderr)
    named = re.fullmatch(r"camopt: cannot write .*/([^/]+): File too large\n", refused.stderr)
    assert named and any(pathlib.Path(name).name == named[1] for name in contents(whole)), (words, refused.stderr)
    # A sweep's finished parts stay for --resume, each of them whole.
    for name, text in (contents(cut) if cut.exists() else {}).items():
        lines = (whole / name).read_bytes().count(b"\n")
        complete = json.loads(text) if name.endswith(".json") else text.count(b"\n") == lines and text.endswith(b"\n")
        assert words[0] == "sweep" and complete, (words, name)


def report_keeps_what_is_there():
    before = contents(SOLVED)
    refused = run("report", SOLVED, **limited(len(before["report.html"]) * 99 // 100))
    assert refused.returncode == 2 and "File too large" in refused.stderr, refused.stderr
    assert contents(SOLVED) == before


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    assert run("solve", CAM, "--out", SOLVED).returncode == 0
    for part in (1, 2):
        made = run("sweep", DRD, "--weights", "simplex:3", "--chunk", "2", "--out", SWEPT / str(part), "--shard", f"{part}/2")
        assert made.returncode == 0, made.stderr
    assert run("sweep", DRD, "--surface", "0.1", "--out", SURFACE).returncode == 0
    print_to_a_full_disk()
    check_to_a_full_disk()
    tried = list(WRITING)
    for words in OPTIONAL:
        if "which this build of camopt does not have" not in run(*words, FOLDER / "optional").stderr:
            tried.append(words)
    for words in tried:
        leaves_the_folder(words)
    report_keeps_what_is_there()
    print(f"{len(PRINTING)} outputs and {len(tried) + 1} folders: none was cut short unsaid")


main()
