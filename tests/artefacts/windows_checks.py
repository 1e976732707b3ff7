# SPDX-License-Identifier: MIT
"""camopt.exe and its installer under Wine: numbers as on Linux, names in any script, sweeps resumed, the command-line tests.

    windows_checks.py CAMOPT_EXE LINUX_CAMOPT WORK [--setup SETUP_EXE] [--tests APPS_TEST]
"""

import argparse
import csv
import json
import math
import os
import pathlib
import pty
import select
import shutil
import signal
import subprocess
import sys
import time

from agreement import judged

ROOT = pathlib.Path(__file__).resolve().parents[2]
WINE = shutil.which("wine64") or "/usr/lib/wine/wine64"
# One of every kind that solves in a second or two.
SCENES = ("drd_cubic_12", "rr_cubic_24", "cam_roller", "cam_infeasible", "inverse_feeder", "barrel_paper_cup", "ocrf_indexing", "valve_intake",
          "servo_drd", "drd_measured")
# Of tests/apps: all but one that sends a signal (check_interrupt types Ctrl-C instead) and one for Open CASCADE.
COMMAND_TESTS = "-SweepCommand.InterruptKeepsResultsAndSuggestsResume:ExportCommand.StepOrWhatToInstall"
SWEEP = ("sweep", str(ROOT / "scenes/drd_cubic_12.toml"), "--vary", "spline.segments=8:71:64", "--workers", "2", "--chunk", "2")


class Faults(list):
    def demand(self, what, holds, found=""):
        print(f"{'passed' if holds else 'FAILED'}: {what}{'' if holds else f': found {found!r}'}", flush=True)
        if not holds:
            self.append(what)


class Wine:
    def __init__(self, work, program):
        self.work, self.program = work, program
        self.environment = dict(os.environ, WINEPREFIX=str(work / "prefix"), WINEDEBUG="-all", LC_ALL="C.UTF-8")

    def run(self, program, *words, **options):
        return subprocess.run([WINE, str(program), *map(str, words)], env=self.environment, capture_output=True, text=True,
                              timeout=600, check=False, cwd=options.get("cwd", self.work))

    def camopt(self, *words, **options):
        return self.run(self.program, *words, **options)

    def wrapper(self):
        """A program for tests that start camopt themselves."""
        path = self.work / "camopt-under-wine"
        path.write_text(f'#!/bin/sh\nWINEPREFIX="{self.work}/prefix" WINEDEBUG=-all LC_ALL=C.UTF-8 exec "{WINE}" "{self.program}" "$@"\n')
        path.chmod(0o755)
        return path


def largest_difference(first, second, path=""):
    """Of two JSON values, relative; and where. Times and texts of paths aside."""
    if isinstance(first, dict) and isinstance(second, dict) and first.keys() == second.keys():
        pairs = [(first[key], second[key], f"{path}.{key}") for key in first if "seconds" not in key and key != "command"]
    elif isinstance(first, list) and isinstance(second, list) and len(first) == len(second):
        pairs = [(a, b, f"{path}[{i}]") for i, (a, b) in enumerate(zip(first, second))]
    elif path.endswith((".at", ".at_deg")) and isinstance(first, (int, float)) and isinstance(second, (int, float)):
        return 0.0, path  # a flat extreme may lie anywhere
    elif isinstance(first, (int, float)) and isinstance(second, (int, float)):
        return abs(first - second) / max(1.0, abs(first)), path
    else:
        return (0.0 if first == second else math.inf), path
    return max((largest_difference(*pair) for pair in pairs), default=(0.0, path))


def check_numbers(wine, linux, faults):
    for name in SCENES:
        scene = ROOT / f"scenes/{name}.toml"
        found = []
        for kind, run in (("windows", wine.camopt), ("linux", lambda *words: subprocess.run([linux, *words], capture_output=True, text=True, check=False))):
            folder = wine.work / kind / name
            run("solve", str(scene), "--solver", "structured", "--out", str(folder))
            found.append(json.loads((folder / "result.json").read_text()) if (folder / "result.json").exists() else {})
        if not all(found):
            faults.demand(f"{name}: solved on Windows and on Linux", False, [bool(one) for one in found])
            continue
        difference, allowed, remark = judged(*found)
        said = "none" if difference is None else f"{difference:.1e}, allowed {allowed:.1e}"
        faults.demand(f"{name}: verdict and objective as on Linux (difference {said})", not remark.startswith("FAILED"), remark)
        one, other = ([run["solver"]["iterations"], run["solver"]["native_status"], run["evaluations"]] for run in found)
        if one == other:
            difference, where = largest_difference(*found)
            faults.demand(f"{name}: result.json as on Linux (largest difference {difference:.1e})", difference < 1e-9, where)
        else:  # round-off has led the search elsewhere, within its gap
            print(f"{name}: iterations, status and evaluations {one}, on Linux {other}")
        names = [sorted(path.name for path in (wine.work / kind / name).glob("*")) for kind in ("windows", "linux")]
        faults.demand(f"{name}: the same files", names[0] == names[1], names)


def check_names(wine, faults):
    """Paths in other scripts, and a console in UTF-8."""
    folder = wine.work / "größe λ 凸轮"
    folder.mkdir(exist_ok=True)
    text = (ROOT / "scenes/drd_cubic_12.toml").read_text()
    (folder / "nocken é.toml").write_text('title = "Größe λ"\n' + "\n".join(line for line in text.splitlines() if not line.startswith("title")), encoding="utf-8")
    run = wine.camopt("solve", "nocken é.toml", "--out", "ergebnis ж", cwd=folder)
    faults.demand("a scene and a folder with names in other scripts", run.returncode == 0 and (folder / "ergebnis ж/report.html").exists(),
                  run.stdout + run.stderr)
    faults.demand("printed in UTF-8", "Größe λ" in run.stdout and "ergebnis ж" in run.stdout, run.stdout[:300])
    run = wine.camopt("solve", "fehlt ü.toml", cwd=folder)
    faults.demand("a fault names its file in UTF-8", run.returncode == 2 and "fehlt ü.toml" in run.stderr, run.stderr)
    run = wine.camopt("export", "ergebnis ж", "--out", "экспорт", "--csv", cwd=folder)
    faults.demand("read back from there", run.returncode == 0 and any((folder / "экспорт").iterdir()), run.stderr)


def table(folder):
    with open(folder / "sweep.csv", newline="", encoding="utf-8") as file:
        return [[cell for name, cell in row.items() if "seconds" not in name] for row in csv.DictReader(file)]


def files_of(out):
    return len(list(out.rglob("*.csv")))


def check_sweep(wine, linux, faults):
    """Stopped by force while it runs, resumed; rows as on Linux."""
    subprocess.run([linux, *SWEEP, "--out", str(wine.work / "linux_sweep")], check=True, capture_output=True)
    out = wine.work / "killed_sweep"
    process = subprocess.Popen([WINE, str(wine.program), *SWEEP, "--out", str(out)], env=wine.environment, cwd=wine.work,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while process.poll() is None and files_of(out) < 4:
        time.sleep(0.02)
    process.send_signal(signal.SIGKILL)
    process.wait()
    resume(wine, out, "killed", faults)


def check_interrupt(wine, faults):
    """Ctrl-C is typed on a terminal, as a person does."""
    out = wine.work / "interrupted_sweep"
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(wine.work)
        os.execvpe(WINE, [WINE, str(wine.program), *SWEEP, "--out", str(out)], dict(wine.environment, TERM="xterm"))
    typed, end = False, time.monotonic() + 120
    while time.monotonic() < end:
        if select.select([terminal], [], [], 0.05)[0]:
            try:
                os.read(terminal, 65536)
            except OSError:  # the other end is closed
                break
        if not typed and files_of(out) >= 4:
            os.write(terminal, b"\x03")
            typed = True
    else:
        os.kill(child, signal.SIGKILL)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    faults.demand("Ctrl-C ends a sweep with exit code 130", typed and status == 130 and not (out / "sweep.csv").exists(), (typed, status))
    resume(wine, out, "interrupted", faults)


def resume(wine, out, what, faults):
    kept = files_of(out)
    run = wine.camopt(*SWEEP, "--out", out, "--resume")
    faults.demand(f"a sweep that was {what} is resumed ({kept} files were kept)", run.returncode == 0 and kept >= 4, run.stderr)
    faults.demand("its rows are those of Linux", table(out) == table(wine.work / "linux_sweep"))


def check_studio(wine, faults):
    page = pathlib.Path(wine.program).parent / "camopt.html"
    made = not page.exists()
    if made:
        page.write_text('<script type="application/json" id="opening-scene">null</script>')
    run = wine.camopt("studio", ROOT / "scenes/drd_cubic_12.toml")
    found = [path for path in (wine.work / "prefix").rglob("camopt.html") if path != page]
    faults.demand("the studio opens the offline page with the scene in it", run.returncode == 0 and
                  any('"scene":' in path.read_text(encoding="utf-8") for path in found), run.stdout + run.stderr)
    if made:
        page.unlink()


def check_installer(wine, setup, faults):
    registry = r"HKCU\Environment"
    wine.run("reg", "add", registry, "/v", "Path", "/t", "REG_EXPAND_SZ", "/d", r"C:\before;%TEMP%", "/f")
    before = {path.name for path in (wine.work / "prefix/drive_c/users").rglob("*") if path.is_file()}
    run = wine.run(setup, "/S")
    installed = list((wine.work / "prefix").rglob("Programs/camopt/camopt.exe"))
    faults.demand("the installer installs without a question", run.returncode == 0 and len(installed) == 1, run.stderr)
    if not installed:
        return
    found = wine.run("reg", "query", registry, "/v", "Path").stdout
    faults.demand("the folder leads the user's Path, which keeps the rest", r"Programs\camopt;C:\before;%TEMP%" in found, found)
    folder = installed[0].parent
    faults.demand("page and licences are installed", (folder / "camopt.html").exists() and (folder / "licenses/LICENSES.txt").exists())
    run = wine.run(installed[0], "solve", folder / "scenes/drd_cubic_12.toml")
    faults.demand("the installed program solves an installed scene", run.returncode == 0, run.stderr)
    wine.run(folder / "uninstall.exe", "/S")
    for _ in range(100):  # it goes on from a copy of itself
        if not folder.exists():
            break
        time.sleep(0.1)
    left = {path.name for path in (wine.work / "prefix/drive_c/users").rglob("*") if path.is_file()} - before
    faults.demand("uninstall.exe removes all of it", not folder.exists() and not any("camopt" in name for name in left), left)
    found = wine.run("reg", "query", registry, "/v", "Path").stdout
    faults.demand("the user's Path is as before", r"    C:\before;%TEMP%" in found, found)


def check_commands(wine, tests, faults):
    run = subprocess.run([tests, f"--gtest_filter={COMMAND_TESTS}", "--gtest_brief=1"], capture_output=True, text=True, check=False,
                         env=dict(os.environ, CAMOPT_TEST_PROGRAM=str(wine.wrapper())), timeout=1100)
    print(run.stdout[-4000:])
    faults.demand("the command-line tests that need no optional library", run.returncode == 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("linux")
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--setup", type=pathlib.Path)
    parser.add_argument("--tests")
    arguments = parser.parse_args()
    if not pathlib.Path(WINE).exists():
        print("*** SKIPPED: no wine64 (scripts/setup --release)")
        return 77
    shutil.rmtree(arguments.work, ignore_errors=True)
    arguments.work.mkdir(parents=True)
    wine, faults = Wine(arguments.work.resolve(), arguments.program.resolve()), Faults()
    run = wine.camopt("--version")
    faults.demand("camopt.exe --version", run.returncode == 0 and run.stdout.startswith("camopt "), run.stdout + run.stderr)
    check_names(wine, faults)
    check_studio(wine, faults)
    if arguments.setup:
        check_installer(wine, arguments.setup.resolve(), faults)
    check_numbers(wine, arguments.linux, faults)
    check_sweep(wine, arguments.linux, faults)
    check_interrupt(wine, faults)
    if arguments.tests:
        check_commands(wine, arguments.tests, faults)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
