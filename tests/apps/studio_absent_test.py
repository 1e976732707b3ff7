# SPDX-License-Identifier: MIT
"""studio_absent_test.py CAMOPT: a camopt without the HTTP library says what is missing, and serves nothing."""
import subprocess
import sys

run = subprocess.run([sys.argv[1], "studio"], capture_output=True, text=True, timeout=60, check=False)
if run.returncode != 2 or run.stdout or "libcpp-httplib-dev" not in run.stderr:
    sys.exit(f"exit {run.returncode}, said {run.stdout!r} and {run.stderr!r}")
