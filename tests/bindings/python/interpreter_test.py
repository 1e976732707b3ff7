# SPDX-License-Identifier: MIT
"""The interpreter during a solve: its lock, Ctrl-C, callbacks, memory."""

import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest

import camopt
import numpy as np
import program

LONG = program.scene_path("tappet_90.toml")  # a search of many seconds


class Threads(unittest.TestCase):
    def test_another_thread_runs_while_one_solves(self):
        scene = camopt.Scene.from_file(LONG)
        scene["solver.max_seconds"] = 2
        ticks, done = [], threading.Event()

        def count():
            while not done.wait(0.001):
                ticks.append(time.monotonic())

        other = threading.Thread(target=count)
        other.start()
        begin = time.monotonic()
        camopt.solve(scene)
        seconds = time.monotonic() - begin
        done.set()
        other.join()
        during = [tick for tick in ticks if begin < tick < begin + seconds]
        self.assertGreater(seconds, 1)
        self.assertGreater(len(during), 100)
        self.assertLess(max(np.diff(during)), 0.5)

    def test_solves_side_by_side_are_those_one_after_another(self):
        names = ("cam_roller.toml", "drd_quintic_12.toml", "rr_cubic_24.toml", "cam_flat.toml")
        scenes = [camopt.Scene.from_file(program.scene_path(name)) for name in names]
        alone = [camopt.solve(scene).certificate() for scene in scenes]
        found = [None] * len(scenes)

        def solve(index):
            found[index] = camopt.solve(scenes[index]).certificate()

        threads = [threading.Thread(target=solve, args=(index,)) for index in range(len(scenes))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, alone)


INTERRUPTED_SOLVE = """
import camopt, os, signal, sys, threading, time
scene = camopt.Scene.from_file(sys.argv[1])
def press():
    time.sleep(float(sys.argv[2]))
    pressed.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)
pressed = []
threading.Thread(target=press, daemon=True).start()
try:
    camopt.solve(scene)
    print("not interrupted")
except KeyboardInterrupt as stop:
    found = stop.solution
    print("interrupted", time.monotonic() - pressed[0], found.verdict, found.success, found.reason)
print("afterwards", camopt.solve(weights=dict(v=.4, a=.4, j=.2)).verdict)
"""
INTERRUPTED_SWEEP = """
import camopt, numpy as np, os, signal
scene = camopt.Scene(weights=dict(v=.4, a=.4, j=.2))
def press(done, rows):
    if done >= 50:
        os.kill(os.getpid(), signal.SIGINT)
try:
    camopt.sweep(scene, {"objective.jerk": np.linspace(0, 1, 50000)}, progress=press)
    print("not interrupted")
except KeyboardInterrupt as stop:
    print("interrupted", len(stop.table), set(stop.table.to_dict()["verdict"]))
"""


class Interrupts(unittest.TestCase):
    def run_script(self, script, *words):
        return subprocess.run([sys.executable, "-B", "-c", script, *words], capture_output=True, text=True, check=True,
                              timeout=120).stdout.splitlines()

    def test_ctrl_c_ends_a_solve_promptly_and_keeps_what_was_found(self):
        for seconds in ("0.3", "3"):
            first, second = self.run_script(INTERRUPTED_SOLVE, LONG, seconds)
            with self.subTest(first):
                word, latency, verdict, success, *reason = first.split()
                self.assertEqual(word, "interrupted")
                self.assertLess(float(latency), 2.0)
                self.assertEqual(success == "True", verdict in ("optimal", "local", "feasible"))
                self.assertEqual(second, "afterwards optimal")

    def test_ctrl_c_ends_a_sweep_and_keeps_its_rows(self):
        word, rows, *verdicts = self.run_script(INTERRUPTED_SWEEP)[0].split()
        self.assertEqual((word, verdicts), ("interrupted", ["{'optimal'}"]))
        self.assertTrue(50 <= int(rows) < 50000)

    def test_what_a_callback_raises_comes_through(self):
        told = []

        def stop(now):
            told.append(now)
            raise LookupError(now.message)

        with self.assertRaises(LookupError) as caught:
            camopt.solve(camopt.Scene.from_file(LONG), progress=stop)
        self.assertEqual(len(told), 1)
        self.assertIsInstance(caught.exception.solution, camopt.Solution)
        solver = camopt.Solver(camopt.Scene.from_file(LONG))
        with self.assertRaises(LookupError):
            solver.solve(progress=stop)
        self.assertIsInstance(solver.solution, camopt.Solution)

    def test_progress_is_told_in_lines(self):
        told = []
        scene = camopt.Scene.from_file(program.scene_path("cam_forces.toml"))
        camopt.solve(scene, progress=told.append)
        self.assertTrue(told)
        self.assertTrue(all(isinstance(now, camopt.Progress) and str(now) and "\n" not in now.message for now in told))
        self.assertTrue([now for now in told if now.round])


def resident_bytes():
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Memory(unittest.TestCase):
    def test_a_thousand_solves_leak_nothing(self):
        scene = camopt.Scene.from_file(program.scene_path("rr_cubic_24.toml"))
        scene.update(cam={"type": "disk", "follower": "translating_roller", "base_radius_mm": 60,
                          "roller_radius_mm": 10})
        solver = camopt.Solver(camopt.Scene(weights={"v": .4, "a": .4, "j": .2}))
        speed = camopt.term("speed", lambda x, y, v, a, j: v, weight=0.3, shape="linear", highest_order=1)

        def once(number):
            solution = camopt.solve(scene, objective__jerk=0.1 + number % 10 / 10, progress=lambda line: None)
            solution.profile(50), solution.to_json(), solution.motion(np.linspace(0, 1, 100))
            solver.update(objective__jerk=number % 7 / 7)
            solver.solve()
            if number % 20 == 0:
                camopt.solve(weights={"j": 1}, segments=4, terms=[speed])
            try:
                scene["spline.segments"] = -number
            except camopt.InputError:
                pass

        for number in range(300):
            once(number)
        before = resident_bytes()
        for number in range(1000):
            once(number)
        grown = resident_bytes() - before
        print(f"1,000 solves: {grown / 1024:.0f} KiB more resident")
        self.assertLess(grown, 1 << 20)


if __name__ == "__main__":
    unittest.main(verbosity=2)
