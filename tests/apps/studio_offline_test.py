# SPDX-License-Identifier: MIT
"""studio_offline_test.py CAMOPT: camopt studio --offline writes the scene into the installed page and opens it as a file."""
import json
import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv.pop(1))
ELEMENT = '<script type="application/json" id="opening-scene">'
SCENE = 'title = "</script><b>ä</b>"\n[motion]\ntype = "DRD"\nlift_mm = 10\nrise_deg = 120\nspeed_rpm = 300\n[spline]\nsegments = 16\n[objective]\njerk = 1\n'


class Offline(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        (self.folder / "bin").mkdir()
        shutil.copy2(PROGRAM, self.folder / "bin/camopt")
        opener = self.folder / "bin/xdg-open"
        opener.write_text(f'#!/bin/sh\nprintf %s "$1" > "{self.folder}/opened"\n')
        opener.chmod(opener.stat().st_mode | stat.S_IXUSR)
        (self.folder / "scene.toml").write_text(SCENE, encoding="utf-8")

    def install(self, place, text):
        (self.folder / place).mkdir(parents=True, exist_ok=True)
        (self.folder / place / "camopt.html").write_text(text, encoding="utf-8")

    def studio(self, *words):
        environment = {**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}", "TMPDIR": str(self.folder)}
        return subprocess.run([self.folder / "bin/camopt", "studio", "--offline", *words], cwd=self.folder, env=environment,
                              capture_output=True, text=True, timeout=60, check=False)

    def test_scene_and_settings_stand_in_the_opened_page(self):
        for place in ("bin", "share/camopt"):
            self.install(place, f"<p>before</p>{ELEMENT}null</script><p>after</p>")
            run = self.studio("scene.toml", "--set", "motion.lift_mm=12")
            self.assertEqual(run.returncode, 0, run.stderr)
            page = pathlib.Path((self.folder / "opened").read_text())
            self.assertIn(str(page), run.stdout)
            found = re.fullmatch(f"<p>before</p>{re.escape(ELEMENT)}([^<]*)</script><p>after</p>", page.read_text(encoding="utf-8"))
            opening = json.loads(found[1])
            self.assertEqual(opening["name"], "scene.toml")
            self.assertIn('title = "</script><b>ä</b>"', opening["scene"])
            self.assertIn("lift_mm = 12", opening["scene"])
            (self.folder / place / "camopt.html").unlink()

    def test_without_a_desktop_the_page_is_named(self):
        (self.folder / "bin/xdg-open").write_text("#!/bin/sh\nexit 3\n")
        self.install("bin", f"{ELEMENT}null</script>")
        run = self.studio()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex(run.stdout, r"camopt\.html\nOpen it in a browser on this machine\.\n$")

    def test_what_is_missing_is_said(self):
        run = self.studio("scene.toml")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("found no camopt.html next to the program", run.stderr)
        self.install("bin", "<p>another page</p>")
        run = self.studio("scene.toml")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertIn("found no element opening-scene", run.stderr)


unittest.main()
