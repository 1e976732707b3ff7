# SPDX-License-Identifier: MIT
"""pairs_test.py PROGRAM ROOT FOLDER PART PARTS [--rest] [--show]: outputs of pairs.py for every PARTS-th kind of scene: written, and
read back by read_back.py, or refused with exit code 2 in the words that REFUSED has. The part after the last: the machines, each with
every format of the controllers.

Without --rest (tier product) what is refused and every third output, others for the next kind, so that each output and each kind is
tried a dozen times; with it (tier nightly) all others. --show prints what each pair does."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import time

import pairs
import read_back

PROGRAM, ROOT, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
PART, PARTS, REST, SHOW = int(sys.argv[4]), int(sys.argv[5]), "--rest" in sys.argv, "--show" in sys.argv
BROKEN = (AssertionError, StopIteration, ValueError, KeyError, subprocess.TimeoutExpired, read_back.ElementTree.ParseError)
CONFIRMED = (0, 2)  # of verify-export: 2 names a column that it does not know
DOUBTS = (0, 3)  # of a solve: it says infeasible by 3


def run(words, folder):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=60, check=False, cwd=folder)


def measured_table(result, path):
    """The motion of a result as displacements of a measured cam."""
    header, rows = read_back.rows_of(result / "motion.csv")
    theta, s = header.index("theta_deg"), next(i for i, name in enumerate(header) if name.startswith("s_"))
    lines, last = [f"theta_deg,{header[s]}"], None
    for row in rows:
        if row[theta] != last and float(row[theta]) < 360.0:
            lines.append(f"{row[theta]},{row[s]}")
            last = row[theta]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def confirm(folder, scene):
    """What a controller, a drawing or a program is told is the design, judged in exact arithmetic by a script that knows no camopt."""
    if any(folder.glob("*.check.json")):
        judged = subprocess.run([sys.executable, ROOT / "scripts" / "verify-export", folder, scene], capture_output=True, text=True, timeout=60,
                                check=False)
        assert judged.returncode in CONFIRMED, judged.stdout + judged.stderr


def words_of(output, kind, folder):
    command, asked, _ = pairs.OUTPUTS[output]
    _, scene, settings = pairs.KINDS[kind]
    given = [ROOT / scene, "--set", "title=" + json.dumps(pairs.TITLE)]
    for setting in settings:
        given += ["--set", setting]
    words = [command]
    for word in (["SCENE", *asked] if command == "solve" else asked):
        words += given if word == "SCENE" else [{"RESULT": folder / "result", "TABLE": folder / "measured.csv"}.get(word, word)]
    if command not in ("check", "report") and "--json" not in words:
        words += ["--out", folder / "out"]
    return words


def judge(output, kind, folder):
    """What a pair does that it must not; empty where all is well."""
    refused = pairs.refusal(output, kind)
    shutil.rmtree(folder / "out", ignore_errors=True)
    words = words_of(output, kind, folder)
    done = run(words, folder)
    if SHOW:
        print(f"{kind} | {output} | {done.returncode} | {done.stderr.strip()[:230]}", flush=True)
    if refused:
        if done.returncode != 2 or not re.search(refused, done.stderr):
            return f"exit code {done.returncode}, {done.stderr.strip()[:300]!r}; it must be refused: {refused}"
        return f"refused, and it left files: {sorted((folder / 'out').iterdir())}" if any((folder / "out").glob("*")) else ""
    if done.returncode not in DOUBTS and words[0] not in ("inspect", "valves"):
        return f"exit code {done.returncode}: {done.stderr.strip()[:300]}"
    written = sorted((folder / "out").rglob("*.*")) if (folder / "out").exists() else []
    if words[0] == "report":
        written = [folder / "result" / name for name in ("report.html", "report.md")]
    if "--json" in words:
        json.loads(done.stdout)
    elif words[0] == "check":
        assert "ok" in done.stdout or "valid" in done.stdout, done.stdout
    elif not written:
        return "nothing was written"
    if output == "result":
        shutil.copytree(folder / "out", folder / "result")
        if (folder / "result" / "motion.csv").exists():
            measured_table(folder / "result", folder / "measured.csv")
        else:
            shutil.copy(ROOT / "scenes" / "measured_cam.csv", folder / "measured.csv")
    if words[0] == "export":
        confirm(folder / "out", folder / "result" / "scene.toml")
    for path in written:
        if path.is_file() and "chunks" not in path.parts:
            read_back.read(path, folder / "result")
    return ""


def judge_machine(name, controller, folder):
    """A machine has its own files and those of its axes, and an electronic cam of each axis; or it is refused before any is written."""
    scene, settings = pairs.MACHINES[name]
    words = ["machine", ROOT / scene, "--out", folder / "out", "--plc", controller]
    for setting in settings:
        words += ["--set", setting]
    done = run(words, folder)
    if SHOW:
        print(f"{name} | {controller} | {done.returncode} | {done.stderr.strip()[:230]}", flush=True)
    refused = pairs.MACHINES_REFUSED.get((name, controller))
    if refused:
        assert done.returncode == 2 and re.search(refused, done.stderr), (done.returncode, done.stderr)
        assert not any((folder / "out").glob("*")), "refused, and it left files"
        return
    assert done.returncode == 0, (done.returncode, done.stderr)
    machine = folder / "out"
    axes = [path for path in machine.iterdir() if path.is_dir()]
    assert len(axes) > 1
    for path in machine.glob("*.*"):
        read_back.read(path, machine)
    for axis in axes:
        names = {path.name for path in axis.iterdir()}
        assert names >= set(pairs.RESULT) | {"plc.json"}, names
        for path in axis.iterdir():
            read_back.read(path, axis)


def is_of_product(row, column):
    """Every third of a table, each row and each column."""
    return (row + column) % 3 == 0


def is_wanted(output, kind):
    """The result is what the other outputs are written from."""
    column = list(pairs.OUTPUTS).index(output)
    quick = pairs.refusal(output, kind) or is_of_product(list(pairs.KINDS).index(kind), column)
    return output == "result" or bool(quick) != REST


def judge_machines():
    faults = 0
    for row, name in enumerate(pairs.MACHINES):
        for column, controller in enumerate(pairs.CONTROLLERS):
            if is_of_product(row, column) == REST:
                continue
            folder = FOLDER / re.sub(r"\W", "_", f"{name} {controller}")
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir(parents=True)
            try:
                judge_machine(name, controller, folder)
            except BROKEN as error:
                faults += 1
                print(f"FAULT {name}, {controller}: {type(error).__name__}: {error}", flush=True)
    return faults


def main():
    faults = judge_machines() if PART == PARTS else 0
    for kind in list(pairs.KINDS)[PART::PARTS] if PART < PARTS else []:
        folder = FOLDER / re.sub(r"\W", "_", kind)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for output in pairs.OUTPUTS:
            if not is_wanted(output, kind):
                continue
            begin = time.monotonic()
            try:
                fault = judge(output, kind, folder)
            except BROKEN as error:
                fault = f"{type(error).__name__}: {error}"
            if time.monotonic() - begin > 5.0:
                print(f"slow: {kind}, {output}: {time.monotonic() - begin:.1f} s")
            if fault:
                faults += 1
                print(f"FAULT {kind}, {output}: {fault}", flush=True)
    print(f"pairs: {faults} faults")
    return 1 if faults else 0


sys.exit(main())
