# SPDX-License-Identifier: MIT
"""Drawings, solids, NC programs, electronic cams, reports: the bytes that `camopt export` writes."""

import pathlib
import tempfile
import unittest

import camopt
import program

ROLLER = program.scene_path("cam_forces.toml")


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = camopt.solve(camopt.Scene.from_file(ROLLER))

    @program.needs_program
    def test_they_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            program.run("export", ROLLER, "--out", folder, "--drawing", "dxf", "--nc", "--cutter-mm", "12", "--spindle-rpm", "4000",
                        "--plc", "codesys,siemens")
            written = pathlib.Path(folder)
            self.assertEqual(self.found.drawing("dxf"), (written / "drawing.dxf").read_bytes())
            self.assertEqual(self.found.nc(cutter_mm=12, spindle_rpm=4000), (written / "cam.nc").read_text())
            for controller in ("codesys", "siemens"):
                name = next(one for one in self.found.files() if one.startswith(controller))
                self.assertEqual(self.found.plc(controller), (written / name).read_text())

    def test_every_name_gives_bytes(self):
        for name in self.found.files():
            try:
                self.assertGreater(len(self.found.file(name)), 100, name)
            except camopt.UnavailableError:  # without cairo or Open CASCADE
                self.assertRegex(name, r"\.(pdf|step)$")
            except camopt.InputError as error:  # of a quintic the jerk jumps
                self.assertRegex(f"{name}: {error}", r"twincat7\..*: .*the jerk jumps")

    def test_one_call_each(self):
        self.assertTrue(self.found.drawing("svg").startswith(b"<"))
        self.assertIn("G1", self.found.nc())
        self.assertIn("<html", self.found.report("html"))
        self.assertIn("# ", self.found.report())
        self.assertNotEqual(self.found.plc("codesys", points=37), self.found.plc("codesys"))
        try:
            self.assertTrue(self.found.step().startswith("ISO-10303-21"))
            self.assertTrue(self.found.drawing().startswith(b"%PDF"))
        except camopt.UnavailableError as error:
            self.assertRegex(str(error), "STEP|PDF")

    def test_export_writes_all_or_none(self):
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder, "made")
            paths = self.found.export(place, ["cam.nc", "report.html"])
            self.assertEqual({pathlib.Path(path).name for path in paths}, {path.name for path in place.iterdir()})
            self.assertEqual((place / "cam.nc").read_text(), self.found.nc())
            with self.assertRaisesRegex(camopt.InputError, 'found "nothing.txt"; allowed for this solution: report.html'):
                self.found.export(pathlib.Path(folder, "none"), ["cam.nc", "nothing.txt"])
            self.assertFalse(pathlib.Path(folder, "none", "cam.nc").exists())

    def test_wrong_calls_are_told(self):
        motion = camopt.solve(weights=dict(a=1))
        for call, error, words in ((motion.nc, camopt.InputError, 'found "cam.nc"; allowed for this solution'),
                                   (lambda: motion.plc("nobody"), camopt.InputError, "codesys"),
                                   (lambda: motion.report("odt"), camopt.InputError, 'allowed: "md" or "html"'),
                                   (lambda: self.found.nc(cuter_mm=3), TypeError, "found the option cuter_mm; allowed: tolerance_mm"),
                                   (lambda: self.found.nc(cutter_mm=-3), camopt.InputError, "cutter_mm: found -3; allowed: a number > 0"),
                                   (lambda: self.found.nc(cutter_mm=9, cutter_in=0.3), camopt.InputError, "cutter"),
                                   (lambda: self.found.nc(direction="down"), camopt.InputError, "climb")):
            with self.assertRaisesRegex(error, words):
                call()


if __name__ == "__main__":
    unittest.main(verbosity=2)
