# SPDX-License-Identifier: MIT
"""tally_test.py CAMOPT: what a part of the trials counts, of files that are as camopt writes them and of files that are not."""
import collections
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import checked_scenes
import checked_trial
import tally
import trials_page

CAMOPT = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None
FORMATS = ("coefficient_csv", "lobe", "codesys", "STL")
# A camopt whose exports are changed by WORDS, which have its folder and its arguments.
FAULTY = f"""#!/usr/bin/env python3
import pathlib, subprocess, sys
done = subprocess.run(["{CAMOPT}", *sys.argv[1:]], check=False)
asked, out = sys.argv, pathlib.Path(sys.argv[sys.argv.index("--out") + 1])
if asked[1] == "export":
    WORDS
sys.exit(done.returncode)
"""
ROW_LOST = """
    if "csv" in asked:
        lines = (out / "plc.csv").read_text().splitlines(keepends=True)
        del lines[len(lines) // 2]
        (out / "plc.csv").write_text("".join(lines))
"""
SOLID_CUT = """
    if "--stl" in asked:
        (out / "cam.stl").write_bytes((out / "cam.stl").read_bytes()[:-7])
"""
FILE_LEFT = """
    if "--lobe" in asked:
        out.mkdir(exist_ok=True)
        (out / "lobe.csv").write_text("s_mm")
"""
SILENT = """
    if "codesys" in asked:
        (out / "codesys.st").unlink()
        sys.exit(1)
"""
PAGE = "".join(f"<!-- {name} -->\n<!-- end of {name} -->\n" for name in ("trials", "exports", "reasons"))


class CountedTrials(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.judges = checked_trial.Judges()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.place = pathlib.Path(folder.name)

    def trial(self, words, kind="cam", with_exports=True):
        program = self.place / "faulty"
        program.write_text(FAULTY.replace("WORDS", words.strip()))
        program.chmod(0o755)
        with mock.patch.dict(checked_trial.FORMATS, {name: checked_trial.FORMATS[name] for name in FORMATS}, clear=True), mock.patch("builtins.print"):
            return checked_trial.Trial(str(program), self.judges, self.place / "kept").run(kind, 1, 0, with_exports)

    def test_what_camopt_writes_is_confirmed_or_refused(self):
        trial = self.trial("pass")
        self.assertEqual({"coefficient_csv": "confirmed", "lobe": "refused", "codesys": "confirmed", "STL": "read back"}, trial.exports)
        self.assertEqual({"scenes": 1, "optimal": 1, "confirmed": 1}, trial.counts)
        self.assertEqual([("lobe", "refused")], [reason[:2] for reason in trial.reasons])
        self.assertFalse((self.place / "kept").exists())

    def test_spoiled_files_are_refuted_and_stay(self):
        for words, name, why in ((ROW_LOST, "coefficient_csv", "REFUTED"), (SOLID_CUT, "STL", "cam.stl is broken"),
                                 (FILE_LEFT, "lobe", "camopt ended"), (SILENT, "codesys", "camopt ended")):
            with self.subTest(name):
                trial = self.trial(words)
                self.assertEqual([name], [own for own, outcome in trial.exports.items() if outcome == "refuted"])
                self.assertIn(why, next(reason for what, outcome, reason in trial.reasons if outcome == "refuted"))
                kept = self.place / "kept" / f"cam_1_0_{name}"
                self.assertTrue((kept / "scene.toml").exists() and any((kept / "exported").iterdir()))

    def test_outcomes_reach_the_page_and_its_next_part(self):
        file = self.place / "page.md"
        file.write_text("before\n" + PAGE + "after\n")
        for _ in range(2):
            page = tally.Trials(file)
            page.add("abc", "cam", collections.Counter(scenes=1, optimal=1, refuted=1), {"STL": "refuted", "NC": "confirmed"},
                     [("STL", "refuted", "cam.stl is broken")])
        page.add("abc", "valve", collections.Counter(scenes=1))
        tally.Trials(file).add("abc", "machine", collections.Counter(scenes=1))
        page.add("abc", "valve", collections.Counter(scenes=1))
        page = tally.Trials(file)
        self.assertEqual([2, 2, 1], [page.next("abc", kind) for kind in ("cam", "valve", "machine")])
        self.assertEqual(0, page.next("abd", "cam"))
        self.assertEqual({"exports": 2, "refuted": 2}, page.exports.rows["abc", "STL"])
        self.assertEqual({"times": 2}, page.reasons.rows["STL", "refuted", "cam.stl is broken"])
        self.assertIn("| all | all | 4 | 0 | 2 |", file.read_text())
        self.assertTrue(file.read_text().startswith("before\n") and file.read_text().endswith("after\n"))

    def test_a_refuted_export_fails_the_part(self):
        file = self.place / "page.md"
        file.write_text(PAGE)
        found = mock.Mock(counts=collections.Counter(scenes=1), exports={"STL": "refuted"}, reasons=[])
        with mock.patch.object(tally, "Trial", return_value=found), mock.patch("builtins.print"):
            arguments = mock.Mock(camopt="camopt", commit="abc", seed=1, exports=True, out=self.place)
            self.assertEqual(1, tally.checked_scene(tally.Trials(file), "cam", self.judges, arguments))

    def test_an_interrupted_part_keeps_what_is_finished(self):
        file = self.place / "page.md"
        file.write_text(PAGE)
        words = ["tally.py", "--camopt", "camopt", "--only", "cam", "--commit", "abc", "--page", str(file)]
        found = mock.Mock(counts=collections.Counter(scenes=1), exports={}, reasons=[])
        with mock.patch.object(tally, "Trial", side_effect=[found, found, KeyboardInterrupt]), mock.patch.object(sys, "argv", words), \
                mock.patch("builtins.print"):
            self.assertEqual(130, tally.main())
        self.assertEqual(2, tally.Trials(file).next("abc", "cam"))

    def test_reasons_without_what_differs(self):
        self.assertEqual(trials_page.reason_cell("camopt: /tmp/a1/result: the jerk jumps at 12.5 deg | x"),
                         trials_page.reason_cell("camopt: /tmp/b2/result: the jerk jumps at -3e-4 deg\n| x"))

    def test_every_class_draws_a_scene(self):
        for kind in checked_scenes.CLASSES:
            with self.subTest(kind):
                self.assertNotEqual(checked_scenes.drawn(kind, 1, 0), checked_scenes.drawn(kind, 1, 1))
                self.assertEqual(checked_scenes.drawn(kind, 1, 0), checked_scenes.drawn(kind, 1, 0))


if __name__ == "__main__":
    unittest.main()
