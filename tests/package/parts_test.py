# SPDX-License-Identifier: MIT
"""parts_test.py PREFIX BINDIR LIBDIR SCENES PART,…: the installed program, moved elsewhere, opens its parts; without their files it
says in which Debian package they are and does the rest; it takes none of another build."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PREFIX, BINDIR, LIBDIR, SCENES = map(pathlib.Path, sys.argv[1:5])
PARTS = sys.argv[5].split(",")
sys.argv[1:] = []
PLAIN, CAM = SCENES / "drd_cubic_12.toml", SCENES / "cam_roller.toml"
# Words of a command that needs the part, and its package.
NEEDS = {"ipopt": (("solve", PLAIN, "--solver", "ipopt"), "camopt-parts"),
         "pdf": (("export", CAM, "--drawing", "pdf", "--set", "spline.segments=12", "--out", "pdf"), "camopt-parts"),
         "step": (("export", CAM, "--step", "--set", "spline.segments=12", "--out", "step"), "camopt-step")}


class Parts(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / BINDIR).mkdir(parents=True)
        shutil.copy2(PREFIX / BINDIR / "camopt", self.folder / BINDIR)
        self.parts = self.folder / LIBDIR / "camopt"
        shutil.copytree(PREFIX / LIBDIR / "camopt", self.parts)

    def run_program(self, *words, **environment):
        given = {name: value for name, value in os.environ.items() if name not in ("CAMOPT_PARTS", "LD_LIBRARY_PATH")}
        return subprocess.run([self.folder / BINDIR / "camopt", *map(str, words)], capture_output=True, text=True, timeout=300,
                              check=False, cwd=self.folder, env={**given, **environment})

    def ipopt(self):
        entries = json.loads(self.run_program("list", "solvers", "--json").stdout)
        return next(entry for entry in entries if entry["name"] == "ipopt")

    def each_needed(self):
        return [NEEDS[part] for part in PARTS if part in NEEDS]

    def test_every_part_is_installed(self):
        self.assertEqual(sorted(path.name for path in self.parts.iterdir()), sorted(f"camopt_part_{part}.so" for part in PARTS))

    def test_they_are_found_beside_the_program(self):
        for words, _ in self.each_needed():
            done = self.run_program(*words)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.ipopt()["available"], "ipopt" in PARTS)

    def test_a_missing_one_names_its_package(self):
        shutil.rmtree(self.parts)
        for words, package in self.each_needed():
            done = self.run_program(*words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"install the Debian package {package}", done.stderr)
        self.assertEqual((self.ipopt()["available"], self.ipopt()["version"]), (False, None))
        done = self.run_program("solve", PLAIN)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_variable_names_another_place(self):
        self.parts.rename(self.folder / "elsewhere")
        for words, _ in self.each_needed():
            done = self.run_program(*words, CAMOPT_PARTS=str(self.folder / "elsewhere"))
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_one_of_another_build_is_refused(self):
        # The program made another one: a part compares with what the compiler may have put into its instructions.
        program = self.folder / BINDIR / "camopt"
        mine = f"{self.run_program('--version').stdout.split()[1]} by ".encode()
        content = program.read_bytes()
        self.assertIn(mine, content)
        program.write_bytes(content.replace(mine, mine.replace(b"by", b"bY")))
        for words, _ in self.each_needed():
            done = self.run_program(*words)
            self.assertEqual(done.returncode, 2)
            self.assertIn("of another camopt; allowed: that of", done.stderr)


unittest.main(verbosity=2)
