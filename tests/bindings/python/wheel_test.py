# SPDX-License-Identifier: MIT
"""The wheel that `pip install .` makes: in an environment of its own, without camopt's tree."""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import program

FOLDER = program.ROOT / "bindings" / "python"
NEEDED = ("pip", "setuptools", "wheel", "venv")
MISSING = [f"python3-{name}" for name in NEEDED if importlib.util.find_spec(name) is None]
OURS = {"PYTHONPATH": "", "PATH": os.environ["PATH"], "HOME": tempfile.gettempdir(),
        "CAMOPT_BUILD_FOLDER": os.environ["CAMOPT_BUILD_FOLDER"]}


def run(*words, **options):
    ended = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)
    if ended.returncode:
        raise AssertionError(f"{words}: {ended.stdout}\n{ended.stderr}")
    return ended.stdout


@unittest.skipIf(MISSING, f"*** SKIPPED: missing is {', '.join(MISSING)}")
class Wheel(unittest.TestCase):
    def test_it_is_installed_by_pip_and_solves(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = pathlib.Path(folder, "environment")
            run(sys.executable, "-m", "venv", "--system-site-packages", environment)
            python = environment / "bin" / "python"
            run(python, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps", FOLDER, env=OURS)
            printed = run(python, "-c", "import camopt; print(camopt.__file__, camopt.__version__, "
                          "camopt.solve(weights=dict(v=.4, a=.4, j=.2), segments=12).verdict)", cwd=folder, env=OURS)
            path, version, verdict = printed.split()
            self.assertTrue(path.startswith(str(environment)), path)
            self.assertEqual((version, verdict), (os.environ["CAMOPT_VERSION"], "optimal"))
            self.assert_only_libraries_of_the_system(pathlib.Path(path).parent)
            parts = {part.name for part in pathlib.Path(path).parent.glob("camopt_part_*.so")}
            self.assertEqual(parts, {part.name for part in pathlib.Path(OURS["CAMOPT_BUILD_FOLDER"], "lib/camopt").glob("*.so")})
            if "camopt_part_ipopt.so" in parts:
                printed = run(python, "-c", "import camopt; print(camopt.solve(weights=dict(j=1), segments=12, name='ipopt').verdict)",
                              cwd=folder, env=OURS)
                self.assertEqual(printed, "optimal\n")
        self.assertFalse((FOLDER / "build").exists())
        self.assertFalse(list(FOLDER.glob("*.egg-info")))

    def test_cmake_installs_the_same_package(self):
        with tempfile.TemporaryDirectory() as prefix:
            run("cmake", "--install", os.environ["CAMOPT_BUILD_FOLDER"], "--prefix", prefix, "--component", "camopt_python")
            package = next(pathlib.Path(prefix).rglob("camopt/__init__.py")).parent
            self.assertEqual({path.name.split(".")[0] for path in package.iterdir()},
                             {"__init__", "_camopt", "_names", "_rules", "_scene", "_solving", "_sweep", "_toml", "py"})
            printed = run(sys.executable, "-B", "-c", "import camopt; print(camopt.__file__)", cwd=prefix,
                          env={"PYTHONPATH": str(package.parent)})
            self.assertTrue(printed.startswith(prefix), printed)

    def assert_only_libraries_of_the_system(self, package):
        extension = next(package.glob("_camopt*.so"))
        lines = run("ldd", extension).splitlines()
        self.assertFalse([line for line in lines if "not found" in line or "libcamopt" in line])
        paths = [line.split("=>")[1].split()[0] for line in lines if "=>" in line]
        self.assertTrue(all(path.startswith(("/lib", "/usr/lib")) for path in paths), paths)
        if not shutil.which("dpkg-query"):
            self.skipTest("*** SKIPPED: no dpkg to ask which packages the libraries are of")
        packages = set()
        for path in paths:
            for spelled in {path, os.path.realpath(path), "/usr" + path, os.path.realpath("/usr" + path)}:
                found = subprocess.run(["dpkg-query", "-S", spelled], capture_output=True, text=True, check=False)
                packages |= {line.split(":")[0] for line in found.stdout.splitlines()}
                if found.returncode == 0 and spelled == os.path.realpath(spelled):
                    # What a -dev package brings is the name without a version, a link.
                    self.assertFalse(found.stdout.split(":")[0].endswith("-dev"), found.stdout)
        print("run-time packages:", " ".join(sorted(packages)))
        self.assertTrue(packages)
        self.assertFalse([name for name in packages if name.endswith("-dev")])


if __name__ == "__main__":
    unittest.main(verbosity=2)
