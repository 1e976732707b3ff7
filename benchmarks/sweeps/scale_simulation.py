#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""scale_simulation.py FOLDER [PICTURE.svg]: sweeps of a million rows on up to 10,000 workers, simulated with the times that
scale_measure.py wrote to FOLDER (scale_parts.csv, scale_rows.csv). Prints tables in Markdown; draws a picture.

Every rank under mpirun, or job of an array, has every N-th chunk from the start, checks all rows first, and solves with one
worker. Afterwards one process merges: it writes every chunk once more. A chunk lasts as long as so many measured rows in a
row, from a place chosen at random, and the measured time until its file is on the disk. Python's standard library only.
"""

import csv
import heapq
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plot import COLOURS, Axis, Panel, Picture  # noqa: E402

ROWS = 1_000_000
WORKERS = (1, 10, 100, 1000, 10_000)
STUDIES = (("quick", 25), ("quick", 250), ("slow", 1), ("slow", 25))  # sweep, rows a chunk


class Measured:
    def __init__(self, folder):
        with open(folder / "scale_parts.csv", newline="", encoding="utf-8") as file:
            self.parts = {row["part"]: float(row["value"]) for row in csv.DictReader(file)}
        self.rows = {}
        with open(folder / "scale_rows.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                self.rows.setdefault(row["sweep"], []).append(float(row["seconds"]))
        self.write = 1e-3 * self.parts["a chunk on its disk"]
        self.check = 1e-6 * self.parts["checking, weights"] * ROWS
        self.finish = 1e-6 * self.parts["finishing"] * ROWS

    def in_order(self, sweep, rows_a_chunk):
        """The chunks of the measured sweep itself."""
        rows = self.rows[sweep]
        return [sum(rows[k:k + rows_a_chunk]) for k in range(0, len(rows), rows_a_chunk)]

    def chunks(self, sweep, rows_a_chunk, rows):
        """Chunks of a larger sweep of such rows."""
        found, generator = self.rows[sweep], random.Random(1)
        twice, sums = found + found, []
        while len(twice) < len(found) + rows_a_chunk:
            twice += found
        for begin in range(len(found)):
            sums.append(sum(twice[begin:begin + rows_a_chunk]))
        return [generator.choice(sums) for _ in range(rows // rows_a_chunk)]


def of_one_process(chunks, workers, write):
    """Seconds until the last chunk is done; a free worker takes the next one."""
    free = [0.0] * workers
    for seconds in chunks:
        heapq.heappush(free, heapq.heappop(free) + seconds + write)
    return max(free)


def in_shards(chunks, jobs, check, write):
    return max(check + sum(chunks[k::jobs]) + write * len(chunks[k::jobs]) for k in range(jobs))


def duration(seconds):
    for size, unit in ((86400, "d"), (3600, "h"), (60, "min")):
        if seconds >= size:
            return f"{seconds / size:.1f} {unit}"
    return f"{seconds:.1f} s"


def validation(measured):
    print("# A million rows, simulated\n\nBy `scale_simulation.py`, with the times of `scale_parts.csv` and `scale_rows.csv`; what it means "
          "stands in [docs/scale.md](../../docs/scale.md). Sweeps that were run, beside the simulation of them:\n")
    print("| sweep | workers | rows | rows a chunk | measured | simulated | |\n|---|--:|--:|--:|--:|--:|--:|")
    for sweep in measured.rows:
        name, workers = sweep.split("_")
        head = f"{name}, {workers} workers: "
        size = int(measured.parts[head + "rows a chunk"])
        real = measured.parts[head + "solving"]
        found = of_one_process(measured.in_order(sweep, size), int(workers), measured.write)
        print(f"| {name} | {workers} | {len(measured.rows[sweep])} | {size} | {real:.2f} s | {found:.2f} s | "
              f"{100 * (found / real - 1):+.0f} % |")
    print()


def study(measured, sweep, size):
    """(workers, seconds, part of them that is work, files a second) …"""
    chunks = measured.chunks(f"{sweep}_1", size, ROWS)
    work = sum(chunks)
    for workers in WORKERS:
        seconds = in_shards(chunks, workers, measured.check, measured.write)
        yield workers, seconds, work / workers / seconds, len(chunks) / (seconds - measured.check)


def tables(measured):
    found = {}
    for sweep, size in STUDIES:
        found[sweep, size] = list(study(measured, sweep, size))
        mean = sum(measured.rows[f"{sweep}_1"]) / len(measured.rows[f"{sweep}_1"])
        print(f"A million {sweep} rows ({1e3 * mean:.3g} ms each), {size} rows a chunk; merging its {ROWS // size:,} chunks takes "
              f"{duration(ROWS // size * measured.write)} more:\n")
        print("| workers | all rows solved | of it solving | files a second |\n|--:|--:|--:|--:|")
        for workers, seconds, part, files in found[sweep, size]:
            print(f"| {workers} | {duration(seconds)} | {100 * part:.1f} % | {files:.3g} |")
        print()
    print(f"After it, on one core: {duration(measured.finish)} to read the chunks, mark the front and write the table.")
    return found


def picture(found):
    one = Picture(1180, 480, "A million rows on many workers", "Simulated with measured times, before merging: every rank or job "
                  "checks all rows first, and its share is fixed")
    one.legend(90, 96, [(f"{sweep} rows, {size} a chunk", COLOURS[k], "line", True)
                        for k, (sweep, size) in enumerate(found)])
    workers = [(n, f"{n:,}") for n in WORKERS]
    times = [(60, "1 min"), (3600, "1 h"), (86400, "1 d"), (864000, "10 d")]
    left = Panel(one, (90, 145, 440, 260), Axis(1, 1e4, "workers", ticks=workers),
                 Axis(3, 2e6, "", ticks=[(10, "10 s"), *times]), "until every row is solved")
    right = Panel(one, (650, 145, 440, 260), Axis(1, 1e4, "workers", ticks=workers),
                  Axis(0, 100, "%", False, [(k, str(k)) for k in range(0, 101, 20)]), "part of that spent solving")
    for colour, rows in zip(COLOURS, found.values()):
        for panel, column, factor in ((left, 1, 1), (right, 2, 100)):
            panel.line([(row[0], factor * row[column]) for row in rows], colour)
            for row in rows:
                panel.mark(row[0], factor * row[column], colour, size=3)
    return one.svg()


def main():
    measured = Measured(pathlib.Path(sys.argv[1]))
    validation(measured)
    found = tables(measured)
    if len(sys.argv) > 2:
        pathlib.Path(sys.argv[2]).write_text(picture(found), encoding="utf-8")


main()
