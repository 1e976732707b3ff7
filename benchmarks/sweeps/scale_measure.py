#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""scale_measure.py CAMOPT SCENES FOLDER: what a study of many scenes is made of, measured on this machine.

Writes FOLDER/scale_parts.csv (part, value, unit) and FOLDER/scale_rows.csv (sweep, row, seconds), which
scale_simulation.py reads. Python's standard library only.
"""

import csv
import os
import pathlib
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time

# Rows of about a millisecond and of some fifty.
SWEEPS = {"quick": ("drd_cubic_12.toml", ["--weights", "simplex:60"], 25),
          "slow": ("cam_roller.toml", ["--vary", "cam.base_radius_mm=21:26:10", "--vary",
                                       "limits.pressure_angle_deg=29:35:4"], 2)}
# What is checked before anything starts: a million weights; rows that have to be read one by one.
CHECKED = (("weights", "drd_cubic_12.toml", ["--weights", "simplex:1412"], 998_991),
           ("other keys", "cam_roller.toml", ["--vary", "cam.base_radius_mm=21:26:300", "--vary",
                                              "limits.pressure_angle_deg=29:35:100"], 30_000))
FILES, BYTES = 200, 8000  # chunks of 25 rows, written as the program writes them


class Measurement:
    def __init__(self, camopt, scenes, folder):
        self.camopt, self.scenes = camopt, pathlib.Path(scenes)
        self.folder = pathlib.Path(folder)
        self.place = pathlib.Path(tempfile.mkdtemp())
        self.parts, self.rows = [], []

    def say(self, part, value, unit):
        self.parts.append((part, f"{value:.5g}", unit))
        print(f"{part}: {value:.5g} {unit}", flush=True)

    def words(self, scene, rows, chunk, out):
        return [self.camopt, "sweep", str(self.scenes / scene), *rows, "--chunk", str(chunk), "--out", str(out)]

    def solve(self, name, workers):
        """One sweep; seconds from the folder's description to its last chunk, and the rows as they took here."""
        scene, rows, chunk = SWEEPS[name]
        out = self.place / f"{name}_{workers}"
        words = self.words(scene, rows, chunk, out)
        subprocess.run([*words, "--workers", str(workers)], check=True, stdout=subprocess.DEVNULL)
        last = max(path.stat().st_mtime_ns for path in (out / "chunks").iterdir())
        wall = (last - (out / "sweep.json").stat().st_mtime_ns) * 1e-9
        with open(out / "sweep.csv", newline="", encoding="utf-8") as file:
            seconds = [float(row["seconds_total"]) for row in csv.DictReader(file)]
        for number, value in enumerate(seconds):
            self.rows.append((f"{name}_{workers}", number, f"{value:.6g}"))
        self.say(f"{name}, {workers} workers: rows", len(seconds), "rows")
        self.say(f"{name}, {workers} workers: rows a chunk", chunk, "rows")
        self.say(f"{name}, {workers} workers: solving", wall, "s")
        self.say(f"{name}, {workers} workers: sum of the rows", sum(seconds), "s")
        return out, len(seconds)

    def bytes_a_row(self, out, rows):
        chunks = sum(path.stat().st_size for path in (out / "chunks").iterdir())
        self.say("chunks", chunks / rows, "bytes a row")
        for file in ("sweep.csv", "sweep.svg", "sweep.html"):
            self.say(file, (out / file).stat().st_size / rows, "bytes a row")

    def checking(self):
        """Until the folder stands: every row is checked first."""
        for what, scene, rows, count in CHECKED:
            out = self.place / scene
            begin = time.perf_counter()
            with subprocess.Popen(self.words(scene, rows, 25, out), stderr=subprocess.DEVNULL) as running:
                while not (out / "sweep.json").exists():
                    time.sleep(0.002)
                seconds = time.perf_counter() - begin
                running.send_signal(signal.SIGINT)
            self.say(f"checking, {what}", 1e6 * seconds / count, "µs a row")

    def finish(self):
        """The end of a sweep that is solved: chunks read, front marked, table and pictures written. What does not grow
        with the rows (the laws' losses) is taken out by two sizes."""
        spent = []
        for divisions, rows in ((40, 861), (140, 10011)):
            words = self.words("drd_cubic_12.toml", ["--weights", f"simplex:{divisions}"], 25, self.place / f"end_{rows}")
            subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
            seconds = []
            for _ in range(3):
                begin = time.perf_counter()
                subprocess.run([*words, "--resume"], check=True, stdout=subprocess.DEVNULL)
                seconds.append(time.perf_counter() - begin)
            spent.append((rows, statistics.median(seconds)))
        (few, short), (many, long) = spent
        self.say("finishing", 1e6 * (long - short) / (many - few), "µs a row")

    def writing(self):
        """Written, on the disk, renamed, and the name on the disk."""
        seconds = []
        for k in range(FILES):
            begin = time.perf_counter()
            with open(self.place / "half", "wb") as file:
                file.write(bytes(BYTES))
                file.flush()
                os.fsync(file.fileno())
            os.rename(self.place / "half", self.place / f"chunk_{k}")
            folder = os.open(self.place, os.O_RDONLY)
            os.fsync(folder)
            os.close(folder)
            seconds.append(time.perf_counter() - begin)
        self.say("a chunk on its disk", 1e3 * statistics.median(seconds), "ms")

    def run(self):
        try:
            self.writing()
            self.checking()
            for name in SWEEPS:
                for workers in (1, 2):
                    out, rows = self.solve(name, workers)
                    if name == "quick" and workers == 1:
                        self.bytes_a_row(out, rows)
            self.finish()
        finally:
            shutil.rmtree(self.place)
        for name, head, lines in (("scale_parts.csv", ("part", "value", "unit"), self.parts),
                                  ("scale_rows.csv", ("sweep", "row", "seconds"), self.rows)):
            with open(self.folder / name, "w", newline="", encoding="utf-8") as file:
                csv.writer(file, lineterminator="\n").writerows([head, *lines])


Measurement(*sys.argv[1:4]).run()
