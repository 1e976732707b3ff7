# SPDX-License-Identifier: MIT
"""mpi_test.py CAMOPT SCENES: sweeps under a real mpirun give the table of a sweep without it, also after a crash.

Exit code 77, with the reason, where mpirun is missing."""

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

CAMOPT, SCENES = sys.argv.pop(1), sys.argv.pop(1)
# A container's only user is root, and a test may need more ranks than there are cores.
MPI_ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1")


def mpirun(ranks, *words):
    return ["mpirun", "-np", str(ranks), "--oversubscribe", CAMOPT, *words]


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

    def finished(self, ranks=2):
        """Of each rank: its share of the chunks."""
        chunks = finished_chunks(self.out())
        return [{name: when for name, when in chunks.items() if int(name[6:12]) % ranks == rank} for rank in range(ranks)]

    def clear(self):
        shutil.rmtree(self.out(), ignore_errors=True)

    def assert_same(self, folder):
        self.assertEqual(timeless_rows(folder), self.expected)

    def start_and_wait(self, *more, ranks=2):
        """A run with some chunks finished, and the process of each rank."""
        running = start(mpirun(ranks, *sweep_words(SCENES, self.out(), *more)))
        self.addCleanup(running.communicate)
        self.addCleanup(running.kill)
        self.assertTrue(wait_for(lambda: all(len(part) >= 3 for part in self.finished()) or running.poll() is not None))
        self.assertIsNone(running.poll())
        processes = {rank_of(child): child for child in children(running.pid) if rank_of(child) is not None}
        self.assertEqual(sorted(processes), list(range(ranks)))
        return running, processes

    def resume(self, ranks=2):
        """The same command continues, by any number of ranks; finished chunks are not solved again."""
        before = finished_chunks(self.out())
        self.assertLess(len(before), CHUNKS)
        self.assertFalse((self.out() / "sweep.csv").exists())
        done = run(mpirun(ranks, *sweep_words(SCENES, self.out(), "--resume")))
        self.assertEqual(done.returncode, 0, done.stderr)
        now = finished_chunks(self.out())
        self.assertEqual({name: now[name] for name in before}, before)
        self.assert_same(self.out())
        self.assertEqual([path for path in self.out().rglob("*.tmp")], [])

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

    def test_a_complete_sweep_is_finished_again(self):
        for _ in range(2):
            done = run(mpirun(2, *sweep_words(SCENES, self.out(), "--resume")))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout.count("Sweep of "), 1, done.stdout)
            self.assert_same(self.out())

    def test_results_of_rows_are_kept(self):
        words = [CAMOPT, "sweep", str(pathlib.Path(SCENES) / "drd_cubic_12.toml"), "--weights", "simplex:3", "--chunk", "2",
                 "--results", "--out", f"{self.out()}/"]
        done = run(["mpirun", "-np", "3", "--oversubscribe", *words])
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = sorted((self.out() / "rows").iterdir())
        self.assertEqual([row.name for row in rows], [f"{k:06}" for k in range(10)])
        self.assertTrue(all((row / "result.json").exists() for row in rows))

    def test_a_killed_rank_costs_unfinished_chunks(self):
        for killed in (0, 1):
            self.clear()
            running, processes = self.start_and_wait()
            everybody = descendants(running.pid)
            kill(processes[killed])
            running.communicate(timeout=60)
            self.assertNotEqual(running.returncode, 0)
            self.assertTrue(wait_for(lambda: not any(map(is_alive, everybody))), "a process lives on")
            self.resume(ranks=2 + killed)

    def test_a_killed_worker_costs_nothing(self):
        running, processes = self.start_and_wait()
        for process in processes.values():
            for worker in children(process):
                kill(worker)
        _, errors = running.communicate(timeout=300)
        self.assertEqual(running.returncode, 0, errors)
        self.assert_same(self.out())

    def test_a_signal_keeps_what_is_finished(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            self.clear()
            running, _ = self.start_and_wait()
            everybody = descendants(running.pid)
            kill(running.pid, number)
            running.communicate(timeout=60)
            self.assertNotEqual(running.returncode, 0)
            self.assertTrue(wait_for(lambda: not any(map(is_alive, everybody))), "a process lives on")
            self.resume()

    def test_an_interrupted_rank_zero_reports_it(self):
        """By the variables of PMI, without a launcher: rank 1 never starts, so rank 0 ends up waiting for it."""
        with subprocess.Popen([CAMOPT, *sweep_words(SCENES, self.out())], env=dict(os.environ, PMI_RANK="0", PMI_SIZE="2"),
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as waiting:
            half = (CHUNKS + 1) // 2
            self.assertTrue(wait_for(lambda: len(self.finished()[0]) == half))
            kill(waiting.pid, signal.SIGTERM)
            said, errors = waiting.communicate(timeout=60)
        self.assertEqual((waiting.returncode, said), (130, ""))
        self.assertIn(f"camopt: interrupted; {half} of {CHUNKS} chunks are finished", errors)
        self.resume()

    def assert_refused(self, said, *more):
        done = run(mpirun(2, *sweep_words(SCENES, self.out(), *more)))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stderr.count(said), 1, done.stderr)
        self.assertEqual(finished_chunks(self.out()), {})

    def test_wrong_input_is_reported_once(self):
        self.assert_refused("allowed: an integer", "--vary", "spline.segments=4,6.5")
        self.assert_refused("found under a launcher with 2 ranks", "--shard", "1/2")
        self.assertFalse(self.out().exists())
        self.out().mkdir()
        (self.out() / "other.txt").write_text("not a sweep", encoding="utf-8")
        self.assert_refused("is not empty and holds no sweep")

    def test_the_program_itself_needs_no_mpi(self):
        needed = subprocess.run(["readelf", "-d", CAMOPT], capture_output=True, text=True, check=True).stdout
        self.assertIn("NEEDED", needed)
        self.assertNotRegex(needed, r"libmpi|libopen-(rte|pal)")


if __name__ == "__main__":
    if not shutil.which("mpirun"):
        print("*** SKIPPED: sweeps under mpirun were NOT tried; missing: mpirun (openmpi-bin)")
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)
