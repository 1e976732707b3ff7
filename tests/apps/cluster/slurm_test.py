# SPDX-License-Identifier: MIT
"""slurm_test.py CAMOPT SCENES SCRIPT: a sweep as a job array of a real Slurm (of one node, started here) gives the
table of a sweep without it; jobs that die lose what they were doing, and the same line submitted again finishes.

SCRIPT: docs/scale/sweep_array.sbatch. Exit code 77, with the reason, where Slurm is not installed."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from private_slurm import PrivateSlurm, missing_packages
from sweep_tables import CHUNKS, SKIPPED, finished_chunks, kill, sweep_words, timeless_rows, wait_for

CAMOPT, SCENES, SCRIPT = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
PARTS = 2


def words_of_array():
    """The words after the script: scene and rows; the script adds the rest."""
    words = sweep_words(SCENES, "none")
    at = words.index("--out")
    return words[1:at] + words[at + 2:]


class Slurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = pathlib.Path(tempfile.mkdtemp(prefix="camopt_slurm_"))
        cls.addClassCleanup(shutil.rmtree, cls.place, ignore_errors=True)
        subprocess.run([CAMOPT, *sweep_words(SCENES, cls.place / "alone")], check=True, capture_output=True)
        cls.expected = timeless_rows(cls.place / "alone")
        cls.slurm = cls.enterClassContext(PrivateSlurm(cls.place))
        cls.slurm.environment["CAMOPT"] = CAMOPT

    def setUp(self):
        self.folder = self.place / self.id().rsplit(".", 1)[1]
        self.folder.mkdir()

    def parts(self):
        return [self.folder / "sweep_parts" / f"part_{i}" for i in range(1, PARTS + 1)]

    def submit(self):
        return self.slurm.submit(self.folder, f"--array=1-{PARTS}", SCRIPT, *words_of_array())

    def said(self):
        return "\n".join(path.read_text() for path in sorted(self.folder.glob("slurm-*.out")))

    def merge(self):
        return subprocess.run([CAMOPT, "sweep", "merge", *map(str, self.parts()), "--out", str(self.folder / "map")],
                              capture_output=True, text=True, check=False)

    def finish(self, before):
        """Submitted again: what was finished is not touched, and then everything is there."""
        self.slurm.wait_for_job(self.submit())
        for part, chunks in zip(self.parts(), before):
            after = finished_chunks(part)
            self.assertEqual({name: after[name] for name in chunks}, chunks)
        done = self.merge()
        self.assertEqual(done.returncode, 0, done.stderr + self.said())
        self.assertEqual(timeless_rows(self.folder / "map"), self.expected)

    def in_the_middle(self):
        """A job whose parts have each finished something and not everything."""
        job = self.submit()
        self.assertTrue(wait_for(lambda: all(len(finished_chunks(part)) >= 2 for part in self.parts())), self.said())
        return job

    def test_an_array_and_merge(self):
        self.slurm.wait_for_job(self.submit())
        done = self.merge()
        self.assertEqual(done.returncode, 0, done.stderr + self.said())
        self.assertEqual(timeless_rows(self.folder / "map"), self.expected)

    def test_a_job_that_is_killed_costs_what_it_was_doing(self):
        job = self.in_the_middle()
        pid = next(int(path.parent.name) for path in pathlib.Path("/proc").glob("[0-9]*/cmdline")
                   if str(self.folder).encode() in working_folder(path) and b"--shard\x001/2" in cmdline(path)
                   and not is_worker(path))
        kill(pid)
        self.slurm.wait_for_job(job)
        before = [finished_chunks(part) for part in self.parts()]
        self.assertLess(len(before[0]), (CHUNKS + 1) // 2)
        self.assertEqual(len(before[1]), CHUNKS // 2, self.said())
        refused = self.merge()
        self.assertEqual(refused.returncode, 2)
        self.assertIn("part_1 is not finished", refused.stderr)
        self.finish(before)

    def test_scancel_keeps_what_is_finished(self):
        job = self.in_the_middle()
        self.slurm.run("scancel", job)
        self.slurm.wait_for_job(job)
        before = [finished_chunks(part) for part in self.parts()]
        self.assertLess(sum(map(len, before)), CHUNKS)
        self.finish(before)
        self.assertIn("interrupted; ", self.said())


def cmdline(path):
    try:
        return path.read_bytes()
    except OSError:
        return b""


def working_folder(path):
    try:
        return str((path.parent / "cwd").readlink()).encode()
    except OSError:
        return b""


def is_worker(path):
    """A worker has the words of the camopt that forked it."""
    parent = int((path.parent / "stat").read_text().rsplit(")", 1)[1].split()[1])
    return cmdline(pathlib.Path(f"/proc/{parent}/cmdline")) == cmdline(path)


if __name__ == "__main__":
    absent = missing_packages()
    if absent:
        print(f"*** SKIPPED: the job array was NOT tried on Slurm; missing packages: {', '.join(absent)}")
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)
