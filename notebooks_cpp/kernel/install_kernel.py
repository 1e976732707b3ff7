# SPDX-License-Identifier: MIT
"""install_kernel.py SESSION [--prefix DIR]: puts the kernel into Jupyter, for this user or below DIR."""

import argparse
import json
import pathlib
import sys
import tempfile

from jupyter_client.kernelspec import KernelSpecManager

NAME = "camopt-cpp20"


def install(session, prefix=None):
    """Returns the folder of the kernel's description."""
    here = pathlib.Path(__file__).resolve().parent
    spec = {
        "argv": [sys.executable, "-B", "-Xfrozen_modules=off", str(here / "kernel.py"), "-f", "{connection_file}"],
        "display_name": "C++20 (camopt)",
        "language": "C++",
        "interrupt_mode": "signal",
        "env": {"CAMOPT_NOTEBOOK_SESSION": str(pathlib.Path(session).resolve())},
    }
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "kernel.json").write_text(json.dumps(spec, indent=1), encoding="utf-8")
        return KernelSpecManager().install_kernel_spec(
            folder, NAME, user=prefix is None, prefix=None if prefix is None else str(prefix))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("session")
    parser.add_argument("--prefix")
    options = parser.parse_args()
    print(f"installed {NAME}: {install(options.session, options.prefix)}")
