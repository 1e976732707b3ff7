# SPDX-License-Identifier: MIT
"""pip install . builds the extension with CMake, from the clone that this folder stands in:

    pip install --no-build-isolation --no-index .

CAMOPT_BUILD_FOLDER: a folder that CMake has configured already (build/release); without it build/pip is made, with the
optional libraries that are found. CAMOPT_CMAKE_OPTIONS: further words for cmake, such as -DCAMOPT_WITH_IPOPT=OFF.
CAMOPT_LICENSE_FOLDER: texts of what is linked in, which a wheel then holds with camopt's.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

import setuptools
from setuptools.command.build_ext import build_ext
from wheel.bdist_wheel import bdist_wheel

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def version():
    return re.search(r"project\(camopt VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def jobs():
    """As many as the machine has cores and, at 1.5 GB each, memory for."""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_AVPHYS_PAGES")
    return max(1, min(os.cpu_count() or 1, int(memory / 1.5e9)))


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        given = os.environ.get("CAMOPT_BUILD_FOLDER")
        folder = pathlib.Path(given) if given else ROOT / "build" / "pip"
        if not given:
            subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DCAMOPT_PYTHON=ON",
                            f"-DPython_EXECUTABLE={getattr(sys, '_base_executable', sys.executable)}",
                            "-DCAMOPT_BUILD_APPS=OFF", "-DCAMOPT_BUILD_TESTS=OFF", "-DCAMOPT_BUILD_BENCHMARKS=OFF",
                            "-DCAMOPT_INSTALL=OFF", "-DCAMOPT_UNITY_BUILD=ON",
                            *shlex.split(os.environ.get("CAMOPT_CMAKE_OPTIONS", ""))], check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "camopt_python", "--parallel", str(jobs())], check=True)
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(folder / "python" / "camopt" / target.name, target)
        # The parts that camopt opens when it uses them stand beside it.
        parts = [shutil.copy2(part, target.parent) for part in sorted((folder / "lib/camopt").glob("camopt_part_*.so"))]
        subprocess.run(["strip", "--strip-unneeded", target, *parts], check=False)


class LicensedWheel(bdist_wheel):
    """With the licences in its .dist-info; setuptools looks for them below this folder only."""

    @property
    def license_paths(self):
        folder = os.environ.get("CAMOPT_LICENSE_FOLDER")
        return sorted(map(str, pathlib.Path(folder).iterdir())) if folder else [str(ROOT / "LICENSE")]


# Nothing is left in the tree of sources: what setuptools makes stands in build/.
WORK = ROOT / "build" / "setuptools"
WORK.mkdir(parents=True, exist_ok=True)
setuptools.setup(version=version(), ext_modules=[setuptools.Extension("camopt._camopt", sources=[])],
                 cmdclass={"build_ext": CMakeBuild, "bdist_wheel": LicensedWheel},
                 options={"build": {"build_base": str(WORK)}, "egg_info": {"egg_base": str(WORK)},
                          "bdist_wheel": {"bdist_dir": str(WORK / "wheel")}})
