# SPDX-License-Identifier: MIT
"""Seconds of a command, and what it answered."""

import json
import resource
import subprocess
import time


def measured(command, **options):
    """Wall, user and system seconds of one command, the JSON on its standard output (None: it is none), the finished process."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
    wall, after = time.perf_counter() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        answer = json.loads(done.stdout)
    except json.JSONDecodeError:
        answer = None
    return wall, after.ru_utime - before.ru_utime, after.ru_stime - before.ru_stime, answer, done
