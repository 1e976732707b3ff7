# SPDX-License-Identifier: MIT
"""camopt.html from disk in a headless browser: first curve, sliders, examples, dropped files, downloads; no network.

usage: offline_page_test.py CAMOPT SCENES PAGE [FOLDER for screenshots]; scripts/offline_page calls it."""
import contextlib
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from browser import browser_of, wait_for  # noqa: E402
from studio import StudioPage  # noqa: E402

PROGRAM, SCENES = sys.argv[1], pathlib.Path(sys.argv[2])
PICTURES = pathlib.Path(sys.argv[4]) if len(sys.argv) > 4 else None
StudioPage.pictures = PICTURES
PAGE = pathlib.Path(sys.argv[3]).resolve()
CAM = SCENES / "cam_roller.toml"
OPENING = '<script type="application/json" id="opening-scene">null</script>'
DROP = """
    const data = new DataTransfer();
    data.items.add(new File([arguments[1]], arguments[0], { type: 'text/plain' }));
    for (const kind of ['dragover', 'drop'])
        document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));"""


def objective_of(scene):
    run = subprocess.run([PROGRAM, "solve", str(scene), "--json"], capture_output=True, text=True, check=False)
    return json.loads(run.stdout)["objective"]


class Offline(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.ends = contextlib.ExitStack()
        cls.folder = pathlib.Path(cls.ends.enter_context(tempfile.TemporaryDirectory()))
        cls.browser = cls.ends.enter_context(browser_of(downloads=cls.folder))

    @classmethod
    def tearDownClass(cls):
        cls.ends.close()

    def setUp(self):
        self.page = self.opened(PAGE)

    def opened(self, file):
        page = StudioPage(self.browser, file.as_uri())
        wait_for("the engine", lambda: page.run("return document.documentElement.dataset.engine") == "ready", 90)
        return page

    def tearDown(self):
        self.assertEqual(self.page.page.complaints(), [])
        addresses = self.page.run("return performance.getEntriesByType('resource').map((one) => one.name)")
        self.assertEqual([one for one in addresses if not one.startswith(("blob:", "data:"))], [])

    def example(self, name):
        self.page.after(lambda: self.page.click(f'[data-example="{name}"]'))

    def test_the_first_curve_is_there_within_a_second(self):
        first = self.page.run("return performance.getEntriesByName('first-contentful-paint')[0].startTime")
        self.assertLess(first, 1000 * float(os.environ.get("CAMOPT_SLOWDOWN", "1")))
        self.assertGreater(self.page.run("return Camopt.page.data.angle.values.length"), 100)
        self.assertEqual(self.page.run("return Camopt.studio.times.length"), 0, "it was solved when the page was made")
        print(f"first curve after {first:.0f} ms, engine ready after {self.page.run('return performance.now()'):.0f} ms at most")
        self.page.picture("offline_first")

    def test_the_policy_forbids_every_connection(self):
        policy = self.page.run("return document.querySelector('meta[http-equiv]').content")
        for part in ("default-src 'none'", "connect-src 'none'", "worker-src blob:", "form-action 'none'"):
            self.assertIn(part, policy)
        text = PAGE.read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"<(?:link|script|img|iframe)[^>]*(?:src|href)=\"(?!data:)[^\"]*\"", text), [])
        self.assertEqual(text.count(OPENING), 1)

    def test_a_slider_draws_its_curve_in_time(self):
        page = self.page
        for i in range(3):
            page.move("objective.jerk", 0.3 + 0.1 * i)  # until the engine is fully compiled
        page.run("Camopt.studio.times.length = 0")
        for i in range(20):
            page.move("objective.jerk", 0.1 + 0.04 * i)
        curves = [one["ms"] for one in page.run("return Camopt.studio.times") if one["stage"] == "curve"]
        median = statistics.median(curves)
        print(f"slider to curve: median {median:.0f} ms, most {max(curves):.0f} ms of {len(curves)}")
        self.assertLess(median, 60 * float(os.environ.get("CAMOPT_SLOWDOWN", "1")))

    def test_every_scene_is_an_example_or_cannot_be_one(self):
        names = set(self.page.run("return [...document.querySelectorAll('[data-example]')].map((one) => one.dataset.example)"))
        for scene in SCENES.glob("*.toml"):
            text = scene.read_text(encoding="utf-8")
            self.assertEqual(scene.stem in names, "[machine]" not in text and not re.search(r'^table *= *"', text, re.M), scene.stem)

    def test_an_example_opens_and_undo_returns(self):
        before = self.page.objective()
        self.example("cam_roller")
        self.assertAlmostEqual(self.page.objective(), objective_of(CAM), delta=1e-9)
        self.assertIn("cam_roller", self.page.run("return document.querySelector('.studio .kind').textContent"))
        self.page.picture("offline_cam")
        self.page.after(lambda: self.page.click("[data-control=undo]"))
        self.assertAlmostEqual(self.page.objective(), before, delta=1e-9)

    def test_examples_are_found_by_words(self):
        shown = """const find = document.querySelector('.examples input[type=search]'); find.value = arguments[0]; find.dispatchEvent(new Event('input'));
            return [...document.querySelectorAll('[data-example]')].filter((one) => !one.hidden).length;"""
        self.assertGreater(self.page.run(shown, ""), 40)
        self.assertIn(self.page.run(shown, "knife edge"), range(1, 6))
        self.assertEqual(self.page.run(shown, "zebra"), 0)

    def test_a_dropped_scene_opens(self):
        self.page.after(lambda: self.page.run(DROP, "mine.toml", CAM.read_text(encoding="utf-8")))
        self.assertAlmostEqual(self.page.objective(), objective_of(CAM), delta=1e-9)
        self.page.run(DROP, "picture.png", "no scene")
        wait_for("the reason", lambda: "no scene file" in self.page.fault())

    def test_a_wrong_scene_is_refused_and_stays_to_be_corrected(self):
        before = self.page.objective()
        self.page.after(lambda: self.page.run(DROP, "wrong.toml", "[motion]\ntype = \"up\"\n"))
        self.assertIn("type", self.page.fault())
        self.assertEqual(self.page.objective(), before)
        self.assertIn('type = "up"', self.page.run("return document.querySelector('.editor textarea').value"))
        self.page.picture("offline_wrong")

    def test_an_address_is_a_scene_that_cannot_be_read(self):
        self.page.after(lambda: self.page.run(DROP, "address.toml", "https://example.com/scene.toml"))
        self.assertNotEqual(self.page.fault(), "")

    def test_downloads(self):
        for what, name in (("scene", "scene.toml"), ("motion", "motion.csv"), ("result", "result.json"),
                           ("certificate", "certificate.json"), ("report", "report.html")):
            self.page.click(f'[data-download-file="{what}"]')
            file = self.folder / name
            wait_for(name, lambda one=file: one.exists() and one.stat().st_size > 0, 60)
        self.assertEqual(json.loads((self.folder / "result.json").read_text())["verdict"], "optimal")

    def test_a_solve_that_is_outdated_is_ended(self):
        slow = (SCENES / "drd_torque.toml").read_text(encoding="utf-8") + "\n[solver]\ngap = 1e-12\nstarts = 100000\nmax_seconds = 600\n"
        self.page.run("Camopt.studio.actions.use(arguments[0], 'slow')", slow)
        wait_for("the long solve", lambda: self.page.run("return document.querySelector('.solving').textContent") != "")
        time.sleep(1)
        begin = time.monotonic()
        self.page.click('[data-example="drd_cubic_32"]')
        wait_for("the newer scene", lambda: "32 segments" in self.page.run("return document.title"), 10)
        self.assertLess(time.monotonic() - begin, 4 * float(os.environ.get("CAMOPT_SLOWDOWN", "1")))

    def test_the_page_begins_with_the_scene_in_it(self):
        opening = json.dumps({"name": "given.toml", "scene": CAM.read_text(encoding="utf-8")}).replace("<", "\\u003c")
        file = self.folder / "opening.html"
        file.write_text(PAGE.read_text(encoding="utf-8").replace(OPENING, OPENING.replace("null", opening)), encoding="utf-8")
        self.page = self.opened(file)
        wait_for("the scene", lambda: abs(self.page.objective() - objective_of(CAM)) < 1e-9, 60)
        self.assertIn("given.toml", self.page.run("return document.querySelector('.studio .kind').textContent"))

    def test_nothing_is_wider_than_a_small_screen(self):
        self.browser.width(390)
        try:
            self.page = self.opened(PAGE)
            self.assertLessEqual(self.page.run("return document.documentElement.scrollWidth"), 390)
            self.page.picture("offline_narrow")
        finally:
            self.browser.width(1440)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
