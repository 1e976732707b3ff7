# SPDX-License-Identifier: MIT
"""Solutions and tables of sweeps in pickles, copies and other processes."""

import concurrent.futures
import copy
import json
import multiprocessing
import pickle
import unittest

import camopt
import numpy as np
import program

SCENES = ("drd_cubic_12.toml", "rr_unequal_return.toml", "cam_roller.toml", "cam_forces.toml", "cam_drdrd.toml",
          "drd_free_knots.toml", "infeasible_velocity_cap.toml", "prescribed_tappet.toml")


def squared(x, y, v, a, j):
    return a * a


def solved(name):
    return camopt.solve(camopt.Scene.from_file(program.scene_path(name)))


def solved_cap(cap):
    """In another process."""
    return camopt.solve(weights=dict(v=.4, a=.4, j=.2), limits=dict(velocity=cap))


class Solutions(unittest.TestCase):
    def assert_same(self, again, found):
        self.assertEqual(again.to_dict(), found.to_dict())
        self.assertEqual(again.certificate(), found.certificate())
        self.assertEqual(again.report(), found.report())
        self.assertEqual(again.report("html"), found.report("html"))
        self.assertEqual(repr(again.relaxation), repr(found.relaxation))
        self.assertEqual(again.motion is None, found.motion is None)
        if found.motion is not None:
            x = np.linspace(found.motion.begin, found.motion.end, 501)
            for order in range(4):
                np.testing.assert_array_equal(again.motion(x, order=order), found.motion(x, order=order))

    def test_pickles_are_the_same_solution(self):
        for name in SCENES:
            with self.subTest(name):
                found = solved(name)
                self.assert_same(pickle.loads(pickle.dumps(found)), found)

    def test_copies_are_the_same_solution(self):
        found = solved("cam_roller.toml")
        for again in (copy.copy(found), copy.deepcopy(found), copy.deepcopy({"found": found})["found"]):
            self.assertIsNot(again, found)
            self.assert_same(again, found)
        self.assertEqual(copy.copy(found).to_json(), found.to_json())

    def test_another_process_hands_them_over(self):
        with concurrent.futures.ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
            found = list(pool.map(solved_cap, (1.9, 0.9)))
        self.assertEqual([one.verdict for one in found], ["optimal", "infeasible"])
        self.assertAlmostEqual(found[0].fun, solved_cap(1.9).fun, places=9)
        self.assertEqual(found[1].relaxation[0].key, "limits.velocity")
        self.assertEqual(found[0].file("motion.csv"), solved_cap(1.9).file("motion.csv"))

    def test_own_terms_go_along(self):
        term = camopt.term("squared", squared, weight=0.5, reference=30, shape="convex", highest_order=2)
        found = camopt.solve(weights=dict(v=.4, a=.4, j=.2), terms=[term])
        again = pickle.loads(pickle.dumps(found))
        self.assertEqual(again.own_terms[0].value, found.own_terms[0].value)
        self.assertEqual(again.fun, found.fun)
        with self.assertRaises((pickle.PicklingError, AttributeError)):
            pickle.dumps(camopt.solve(terms=[camopt.term("lambda", lambda x, y, v, a, j: v * v, weight=1)]))

    def test_of_another_version_they_are_refused(self):
        call, arguments, state = solved("drd_cubic_12.toml").__reduce_ex__(2)[:3]
        text = json.loads(state[1])
        text["camopt"] = "0.0.1"
        again = call(*arguments)
        with self.assertRaisesRegex(camopt.InputError, "found a result of camopt"):
            again.__setstate__((state[0], json.dumps(text), *state[2:]))


class Tables(unittest.TestCase):
    def test_pickles_and_copies_are_the_same_table(self):
        scene = camopt.Scene.from_file(program.scene_path("cam_roller.toml"))
        for axes in ({"objective.jerk": "0:1:3"}, {"limits.velocity": [0.5, 2.0]}):
            table = camopt.sweep(scene, axes)
            for again in (pickle.loads(pickle.dumps(table)), copy.copy(table), copy.deepcopy(table)):
                self.assertEqual(again.csv(), table.csv())
                self.assertEqual(again.summary(), table.summary())
                self.assertEqual(again.keys, table.keys)
                for name, column in table.to_dict().items():
                    np.testing.assert_array_equal(again.to_dict()[name], column, err_msg=name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
