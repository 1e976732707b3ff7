# SPDX-License-Identifier: MIT
"""mpi_test.py CAMOPT SCENES MODULE: sweeps under a real mpirun give the table of a sweep without it, whoever dies.

MODULE: camopt_mpi.so of this build, or "none". Exit code 77, with the reason, where it or mpirun is missing."""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

from sweep_tables import (CHUNKS, ROWS, SKIPPED, children, descendants, finished_chunks, is_alive, kill, sweep_words,
                          timeless_rows, wait_for)

CAMOPT, SCENES, MODULE = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
# A container's only user is root, and a test may need more ranks than there are cores.
MPI_ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1")


def mpirun(ranks, *words, program=CAMOPT):
    return ["mpirun", "-np", str(ranks), "--oversubscribe", str(program), *words]


def start(command):
    return subprocess.Popen(command, env=MPI_ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def run(command):
    return subprocess.run(command, env=MPI_ENVIRONMENT, capture_output=True, text=True, timeout=300, check=False)


def rank_of(process):
    try:
        words = pathlib.Path(f"/proc/{process}/environ").read_bytes().split(b"\0")
    except (FileNotFoundError, PermissionError):
        return None
    found = [word.split(b"=")[1] for word in words if word.startswith(b"OMPI_COMM_WORLD_RANK=")]
    return int(found[0]) if found else None


class Mpi(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.place, ignore_errors=True)
        done = run([CAMOPT, *sweep_words(SCENES, cls.place / "alone")])
        assert done.returncode == 0, done.stderr
        cls.expected = timeless_rows(cls.place / "alone")
        assert len(cls.expected) == 1 + ROWS

    def out(self):
        return self.place / self.id().rsplit(".", 1)[1]

    def assert_same(self, folder):
        self.assertEqual(timeless_rows(folder), self.expected)

    def start_and_wait(self, *more, ranks=2):
        """A run with some chunks finished, and the process of each rank."""
        running = start(mpirun(ranks, *sweep_words(SCENES, self.out(), *more)))
        self.addCleanup(running.communicate)
        self.addCleanup(running.kill)
        self.assertTrue(wait_for(lambda: len(finished_chunks(self.out())) >= 3 or running.poll() is not None))
        self.assertIsNone(running.poll())
        processes = {rank_of(child): child for child in children(running.pid) if rank_of(child) is not None}
        self.assertEqual(sorted(processes), list(range(ranks)))
        return running, processes

    def resume(self, before, ranks=2):
        """The same command goes on; what was finished is not touched."""
        self.assertLess(len(before), CHUNKS)
        self.assertFalse((self.out() / "sweep.csv").exists())
        done = run(mpirun(ranks, *sweep_words(SCENES, self.out(), "--resume")))
        self.assertEqual(done.returncode, 0, done.stderr)
        after = finished_chunks(self.out())
        self.assertEqual({name: after[name] for name in before}, before)
        self.assert_same(self.out())

    def test_two_and_four_ranks(self):
        for ranks in (2, 4):
            out = self.out().with_name(f"ranks_{ranks}")
            done = run(mpirun(ranks, *sweep_words(SCENES, out)))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, "")
            self.assertEqual(done.stdout.count("Sweep of "), 1, done.stdout)
            self.assertIn(f"{ROWS} ({ROWS} optimal)", done.stdout)
            self.assert_same(out)

    def test_several_workers_a_rank(self):
        done = run(mpirun(2, *sweep_words(SCENES, self.out(), "--workers", "2")))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same(self.out())

    def test_shards_of_two_runs_are_merged(self):
        parts = [str(self.out().with_name(f"part_{i}")) for i in (1, 2)]
        for i, part in enumerate(parts, 1):
            done = run(mpirun(2, *sweep_words(SCENES, part, "--shard", f"{i}/2")))
            self.assertEqual(done.returncode, 0, done.stderr)
        done = run([CAMOPT, "sweep", "merge", *parts, "--out", str(self.out())])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same(self.out())

    def test_a_killed_rank_costs_what_it_was_doing(self):
        for killed in (0, 1):
            shutil.rmtree(self.out(), ignore_errors=True)
            running, processes = self.start_and_wait()
            everybody = descendants(running.pid)
            kill(processes[killed])
            running.communicate(timeout=60)
            self.assertNotEqual(running.returncode, 0)
            self.assertTrue(wait_for(lambda: not any(map(is_alive, everybody))), "a process lives on")
            self.resume(finished_chunks(self.out()))

    def test_a_killed_worker_costs_nothing(self):
        running, processes = self.start_and_wait()
        for process in processes.values():
            (leader,) = children(process)
            for worker in children(leader):
                kill(worker)
        _, errors = running.communicate(timeout=300)
        self.assertEqual(running.returncode, 0, errors)
        self.assert_same(self.out())

    def test_the_others_go_on_without_the_workers_of_a_rank(self):
        running, processes = self.start_and_wait()
        (leader,) = children(processes[1])
        kill(leader)
        _, errors = running.communicate(timeout=300)
        self.assertEqual(running.returncode, 0, errors)
        self.assert_same(self.out())

    def test_a_signal_keeps_what_is_finished(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            shutil.rmtree(self.out(), ignore_errors=True)
            running, _ = self.start_and_wait()
            everybody = descendants(running.pid)
            kill(running.pid, number)
            running.communicate(timeout=60)
            self.assertNotEqual(running.returncode, 0)
            self.assertTrue(wait_for(lambda: not any(map(is_alive, everybody))), "a process lives on")
            self.resume(finished_chunks(self.out()))

    def test_wrong_input_is_told_once(self):
        done = run(mpirun(2, *sweep_words(SCENES, self.out(), "--vary", "spline.segments=4,6.5")))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stderr.count("allowed: an integer"), 1, done.stderr)
        self.assertFalse(self.out().exists())

    def test_without_the_module(self):
        """What a build without MPI is: the program alone in a folder."""
        lonely = self.out().with_suffix(".bin") / "camopt"
        lonely.parent.mkdir()
        shutil.copy2(CAMOPT, lonely)
        done = run(mpirun(2, *sweep_words(SCENES, self.out()), program=lonely))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("built without MPI", done.stderr)
        self.assertFalse(self.out().exists())
        done = run([str(lonely), *sweep_words(SCENES, self.out())])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same(self.out())

    def test_the_program_itself_needs_no_mpi(self):
        needed = subprocess.run(["readelf", "-d", CAMOPT], capture_output=True, text=True, check=True).stdout
        self.assertIn("NEEDED", needed)
        self.assertNotRegex(needed, r"libmpi|libopen-(rte|pal)")


if __name__ == "__main__":
    absent = [what for what, there in (("camopt_mpi.so (libopenmpi-dev, CAMOPT_WITH_MPI)", MODULE != "none"),
                                       ("mpirun (openmpi-bin)", shutil.which("mpirun"))) if not there]
    if absent:
        print(f"*** SKIPPED: sweeps under mpirun were NOT tried; missing: {', '.join(absent)}")
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)
