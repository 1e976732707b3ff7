# SPDX-License-Identifier: MIT
"""reduce_test.py CAMOPT ROOT: scripts/reduce keeps the fault, and nothing that it does not need."""
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

CAMOPT, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.argv[1:] = []

# A program whose fault needs two keys, one number above a bound and one entry of an array.
FAULTY = f"#!{sys.executable} -SE\n" + """
import json, sys, tomllib
scene = tomllib.load(open(sys.argv[2], "rb"))
if "type" not in scene.get("motion", {}):
    sys.exit(2)
points = scene["motion"].get("via", [])
wrong = scene.get("limits", {}).get("velocity", 0) > 1.234 and any(point.get("at") == 0.5 for point in points)
if wrong:
    print("singular basis", file=sys.stderr)
print(json.dumps({"verdict": "failed" if wrong else "optimal", "objective": 2.0 if wrong else 1.0}))
sys.exit(1 if wrong else 0)
"""
SCENE = """title = "a scene"
[motion]
type = "DRD"
lift_mm = 12.3456
via = [{ at = 0.1, displacement = 0.01 }, { at = 0.5, displacement = 0.5 }, { at = 0.75, velocity = 1.2 }]
[[motion.corridor]]
from_deg = 10.0
displacement = { min = 0.1 }
[spline]
segments = 24
[objective]
jerk = 1.0
[limits]
velocity = 1.73205080756
acceleration = { min = -8.0, max = 9.0 }
"""


def reduced(text, *conditions, camopt=CAMOPT, name="scene.toml"):
    """Exit status, and the reduced scene; None: none was written."""
    with tempfile.TemporaryDirectory() as folder:
        scene, out = pathlib.Path(folder) / name, pathlib.Path(folder) / "out.toml"
        scene.write_text(text)
        run = subprocess.run([sys.executable, "-B", ROOT / "scripts/reduce", scene, "--camopt", camopt, "--out", out, *conditions],
                             capture_output=True, text=True, timeout=600, check=False)
        return run.returncode, out.read_text() if out.exists() else None


class OfAProgramWithAFault(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = pathlib.Path(folder.name) / "faulty"
        self.program.write_text(FAULTY)
        self.program.chmod(0o755)

    def reduced(self, *conditions, text=SCENE):
        status, left = reduced(text, *conditions, camopt=str(self.program))
        return status, tomllib.loads(left) if left is not None else None

    def test_each_condition_finds_what_the_fault_needs(self):
        wanted = {"motion": {"type": "DRD", "via": [{"at": 0.5}]}, "limits": {"velocity": 2.0}}
        for conditions in ([], ["--exit", "1"], ["--verdict", "failed"], ["--stderr", "singular b.sis"],
                           ["--objective", "1.0", "--tol", "1e-3"], ["--objective", "2.0", "--near"],
                           ["--test", f"sh -c '{self.program} solve $0 2>&1 | grep -q singular'"]):
            with self.subTest(conditions):
                self.assertEqual(self.reduced(*conditions), (0, wanted))

    def test_a_scene_without_the_fault(self):
        self.assertEqual(self.reduced("--verdict", "infeasible"), (1, None))

    def test_a_refused_scene_does_not_show_another_fault(self):
        status, left = self.reduced("--exit", "2")
        self.assertEqual((status, left), (1, None))

    def test_a_file_that_is_no_scene(self):
        self.assertEqual(self.reduced(text="[motion")[0], 2)


class OfCamopt(unittest.TestCase):
    def test_an_infeasible_scene_stays_infeasible(self):
        text = (ROOT / "scenes/infeasible_velocity_cap.toml").read_text()
        status, left = reduced(text, "--verdict", "infeasible", "--set", "solver.explain_seconds=0")
        self.assertEqual(status, 0)
        scene = tomllib.loads(left)
        self.assertNotIn("title", scene)
        self.assertEqual(set(scene) - {"objective"}, {"motion", "limits"}, left)
        self.assertLess(len(left), len(text) / 2)

    def test_tables_beside_the_scene_are_found(self):
        scene = ROOT / "scenes/drd_measured.toml"
        self.assertTrue(scene.exists())
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "out.toml"
            run = subprocess.run([sys.executable, "-B", ROOT / "scripts/reduce", scene, "--camopt", CAMOPT, "--out", out, "--test",
                                  "grep -q measured_cam.csv", "--exit", "0"], capture_output=True, text=True, timeout=600, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            left = tomllib.loads(out.read_text())
            self.assertEqual(left["measured"], {"table": "measured_cam.csv"})
            self.assertNotIn("solver", left)


if __name__ == "__main__":
    unittest.main()
