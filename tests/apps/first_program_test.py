# SPDX-License-Identifier: MIT
"""first_program_test.py FIRST CAMOPT SCENES: the program of scripts/demo does what the whole one does, and names what it lacks."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

FIRST, WHOLE, SCENES = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
sys.argv[1:] = []
NOT_ITS_OWN = "`scripts/build release` builds all commands and kinds of cams"


def run(program, *words):
    return subprocess.run([program, *map(str, words)], capture_output=True, text=True, timeout=300, check=False)


def solved(program, scene, *words):
    """The files of a result by their names, without what tells the time."""
    with tempfile.TemporaryDirectory() as folder:
        done = run(program, "solve", SCENES / scene, "--out", folder, *words)
        assert done.returncode == 0, done.stderr
        return {path.name: path.read_text() for path in pathlib.Path(folder).iterdir()}


class First(unittest.TestCase):
    def test_the_result_is_that_of_the_whole_program(self):
        first, whole = (solved(program, "cam_roller.toml", "--dxf") for program in (FIRST, WHOLE))
        self.assertEqual(sorted(first), sorted(whole))
        for name in sorted(set(first) - {"result.json", "report.md", "report.html"}):  # these name seconds and the folder
            self.assertEqual(first[name], whole[name], name)

    def test_the_table_is_that_of_the_whole_program(self):
        first, whole = (run(program, "table", "spline-vs-modified-sine") for program in (FIRST, WHOLE))
        self.assertEqual((first.returncode, first.stdout), (0, whole.stdout))

    def test_a_command_that_it_has_not(self):
        done = run(FIRST, "export", SCENES / "cam_roller.toml", "--out", "nowhere")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("unknown command 'export'; allowed: solve, check, table", done.stderr)
        self.assertIn(NOT_ITS_OWN, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)

    def test_its_help_names_its_commands_and_no_others(self):
        text = run(FIRST, "--help").stdout
        self.assertIn(NOT_ITS_OWN, text)
        for command in ("camopt export", "camopt sweep", "camopt studio"):
            self.assertNotIn(command, text)

    def test_a_kind_of_cam_that_it_has_not(self):
        for scene, kind in (("barrel_paper_cup.toml", "barrel"), ("tappet_75.toml", "remote"), ("inverse_feeder.toml", "inverse")):
            with self.subTest(scene):
                done = run(FIRST, "check", SCENES / scene)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertRegex(done.stderr, rf'{scene}:\d+:\d+: cam.type: found "{kind}"; allowed: "disk" in this program')
                self.assertEqual(run(WHOLE, "check", SCENES / scene).returncode, 0)

    def test_the_whole_program_lacks_nothing(self):
        done = run(WHOLE, "no_such_command")
        self.assertEqual(done.returncode, 2)
        self.assertNotIn("scripts/build", done.stderr + run(WHOLE, "--help").stdout)


unittest.main()
