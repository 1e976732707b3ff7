# SPDX-License-Identifier: MIT
"""Sweeps: the rows of the program's sweep, to the last bit, whatever the number of threads."""

import csv
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

import camopt
import numpy as np
import program

SECONDS = ("seconds_solve", "seconds_total")


def rows_of(text):
    rows = list(csv.DictReader(io.StringIO(text)))
    for row in rows:
        for name in SECONDS:
            row.pop(name)
    return rows


def swept_by_program(scene, *words):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "sweep")
        program.run("sweep", program.scene_path(scene), *words, "--out", str(out), "--workers", "2")
        return rows_of((out / "sweep.csv").read_text())


class Rows(unittest.TestCase):
    @program.needs_program
    def test_they_are_those_of_the_program(self):
        weights = np.linspace(0, 1, 200)
        vary = "objective.jerk=" + ",".join(map(repr, weights.tolist()))
        theirs = swept_by_program("drd_cubic_12.toml", "--vary", vary)
        scene = camopt.Scene.from_file(program.scene_path("drd_cubic_12.toml"))
        for workers in (1, 3):
            self.assertEqual(rows_of(camopt.sweep(scene, {"objective.jerk": weights}, workers=workers).csv()), theirs)
        self.assertEqual(len(theirs), 200)

    @program.needs_program
    def test_so_are_those_of_cams_dimensions_and_texts(self):
        theirs = swept_by_program("cam_roller.toml", "--vary", "cam.base_radius_mm=20:24:2", "--weights", "simplex:2")
        scene = camopt.Scene.from_file(program.scene_path("cam_roller.toml"))
        table = camopt.sweep(scene, {"cam.base_radius_mm": "20:24:2", **camopt.simplex_weights(2)})
        self.assertEqual(rows_of(table.csv()), theirs)

    @program.needs_program
    def test_the_weight_study_has_the_numbers_of_the_program(self):
        theirs = swept_by_program("drd_cubic_12.toml", "--vary", "objective.jerk=0:1:21")
        example = program.ROOT / "bindings" / "python" / "examples" / "weight_study.py"
        lines = [line for line in example.read_text().splitlines() if line.strip() and not line.startswith("#")]
        self.assertLessEqual(len(lines), 20)
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder, "sweep.csv")
            printed = subprocess.run([sys.executable, "-B", example, program.scene_path("drd_cubic_12.toml"), out],
                                     capture_output=True, text=True, check=True).stdout
            self.assertEqual(rows_of(out.read_text()), theirs)
        self.assertEqual(printed.count("jerk weight"), 22)

    def test_columns_are_those_of_the_file(self):
        scene = camopt.Scene(weights={"v": 1, "a": 1, "j": 1}, segments=8, limits={"velocity": 1.8})
        table = camopt.sweep(scene, {"limits.velocity": [1.2, 1.6, 1.7], "spline.segments": np.array([6, 12])})
        columns, rows = table.to_dict(), list(csv.DictReader(io.StringIO(table.csv())))
        self.assertEqual(list(columns), list(rows[0]))
        self.assertEqual((len(table), table.keys), (6, ["limits.velocity", "spline.segments"]))
        for name, column in columns.items():
            self.assertEqual(column.shape, (6,), name)
            for value, cell in zip(column, (row[name] for row in rows)):
                if column.dtype.kind == "f":
                    self.assertTrue(np.isnan(value) if cell == "" else value == float(cell), (name, value, cell))
                else:
                    self.assertEqual(str(int(value)) if column.dtype.kind in "bi" else value, cell, name)
        self.assertIn("infeasible", columns["verdict"])
        records = camopt.structured(columns)
        self.assertEqual(records["objective"][-1], columns["objective"][-1])
        self.assertIn("6 (", str(table))


class Calls(unittest.TestCase):
    SCENE = camopt.Scene(weights={"v": .4, "a": .4, "j": .2})

    def test_progress_counts_to_the_end_in_this_thread(self):
        told = []
        axes = {"objective.jerk": np.linspace(0, 1, 60)}
        camopt.sweep(self.SCENE, axes, workers=2, progress=lambda *now: told.append(now))
        self.assertEqual(told, sorted(told))
        self.assertEqual(told[-1], (60, 60))

    def test_what_a_callback_raises_comes_through_with_the_rows(self):
        class Enough(Exception):
            pass

        def stop(done, rows):
            if done >= 10:
                raise Enough(done)

        weights = np.linspace(0, 1, 20000)
        with self.assertRaises(Enough) as caught:
            camopt.sweep(self.SCENE, {"objective.jerk": weights}, progress=stop)
        self.assertTrue(10 <= len(caught.exception.table) < 20000)
        # Its first row is that of a whole chunk; with two workers this need not be the first one.
        mine = caught.exception.table.to_dict()
        first = int(np.argmin(np.abs(weights - mine["objective.jerk"][0])))
        whole = camopt.sweep(self.SCENE, {"objective.jerk": weights[first:first + 25]}, chunk=25).to_dict()
        self.assertEqual(mine["objective"][0], whole["objective"][0])

    def test_wrong_axes_are_told_before_anything_is_solved(self):
        for axes, words in (({"objective.jerk": []}, "no value"), ({}, "axis|vary"),
                            ({"spline.degree": [3, 4]}, "row 1 "),
                            ({("objective.velocity", "objective.jerk"): [1, 2]}, "allowed: one value a row"),
                            ({"objective.jerk": "0:1"}, "objective.jerk")):
            with self.subTest(axes), self.assertRaisesRegex(camopt.InputError, words):
                camopt.sweep(self.SCENE, axes)


if __name__ == "__main__":
    unittest.main(verbosity=2)
