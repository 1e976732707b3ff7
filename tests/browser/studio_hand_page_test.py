# SPDX-License-Identifier: MIT
"""camopt studio by mouse alone: handles dragged in the chart, buttons, units, typed units, downloads.

usage: studio_hand_page_test.py CAMOPT SCENES [FOLDER for screenshots]"""
import pathlib
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from browser import browser_of, wait_for  # noqa: E402
from studio import studio  # noqa: E402

PROGRAM, SCENES = sys.argv[1], pathlib.Path(sys.argv[2])
PICTURES = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
PROGRAM_SCENE, POINTS = SCENES / "cam_drdrd.toml", SCENES / "drd_via_points.toml"


class Hand:
    """A page and what a user does with a mouse: real pointer events at places of the screen."""

    def __init__(self, page, address):
        self.page, self.driver, self.run = page, page.driver, page.js
        self.driver.get(address)
        wait_for("the page", lambda: self.run("return document.documentElement.dataset.studio === 'ready'"), 90)

    def after(self, act):
        """Waits until what was asked by `act` is answered and drawn."""
        settled = lambda: int(self.run("return document.documentElement.dataset.settled || '0'"))
        before = settled()
        act()
        wait_for("an answer", lambda: settled() > before, 90)

    def actions(self):
        from selenium.webdriver.common.action_chains import ActionChains
        return ActionChains(self.driver, duration=20)

    def find(self, selector):
        """The element in the middle of the screen, where nothing that stays at an edge hides it."""
        element = self.driver.find_element("css selector", selector)
        self.run("arguments[0].scrollIntoView({block: 'center', inline: 'nearest'})", element)
        return element

    def click(self, selector, answered=True):
        act = lambda: self.actions().move_to_element(self.find(selector)).click().perform()
        if answered:
            self.after(act)
        else:
            act()

    def drag(self, words, right, down, steps=4):
        """A handle by its words, so many pixels."""
        def act():
            chain = self.actions().click_and_hold(self.find(f'[data-handle="{words}"]'))
            for _ in range(steps):
                chain = chain.move_by_offset(right // steps, down // steps)
            chain.release().perform()
        self.after(act)

    def choose(self, selector, value):
        """The list is opened by the mouse, its entry by the keyboard, as the system's own list cannot be clicked."""
        from selenium.webdriver.support.ui import Select
        self.after(lambda: Select(self.find(selector)).select_by_value(value))

    def write(self, key, text, answered=True):
        from selenium.webdriver.common.keys import Keys
        def act():
            field = self.find(f'[data-key="{key}"] input.number')
            self.actions().double_click(field).send_keys(text, Keys.ENTER).perform()
        if answered:
            self.after(act)
        else:
            act()

    def shown(self, key):
        return float(self.run('return document.querySelector(`[data-key="${arguments[0]}"] input.number`).value', key))

    def has(self, selector):
        return self.run("return Boolean(document.querySelector(arguments[0]))", selector)

    def fault(self):
        return self.run("return document.querySelector('.fault').textContent")

    def handles(self):
        return self.run("return [...document.querySelectorAll('[data-handle]')].map((one) => one.dataset.handle)")

    def groups(self):
        return self.run("return [...document.querySelectorAll('.group[data-table] > summary')].map((one) => one.textContent)")

    def distance(self, words, key):
        """mm between a handle and the curve of the chart at its angle."""
        return self.run("""
            const chart = Camopt.page.charts.charts.get('displacement'), rect = chart.plot.over.getBoundingClientRect();
            const box = document.querySelector(`[data-handle="${arguments[0]}"]`).getBoundingClientRect();
            const at = chart.plot.posToVal(box.left + box.width / 2 - rect.left, 'x'), value = chart.plot.posToVal(box.top + box.height / 2 - rect.top, 'y');
            return Math.abs(value - chart.curve.values[Camopt.page.angle.rowOf(at)]);""", words, key)

    def picture(self, name):
        if PICTURES:
            PICTURES.mkdir(parents=True, exist_ok=True)
            time.sleep(0.3)
            self.driver.save_screenshot(str(PICTURES / f"{name}.png"))


class ByMouse(unittest.TestCase):
    width, scheme = 1440, "light"

    def open(self, scene):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        running = self.enterContext(studio(PROGRAM, scene))
        browser = self.enterContext(browser_of(self.width, self.scheme, downloads=folder))
        self.downloads, self.hand = pathlib.Path(folder), Hand(browser, running.address)
        if self.width < 980:
            self.hand.click(".all-groups > summary", answered=False)
        return self.hand

    def picture(self, name):
        self.hand.picture(f"{name}-{self.width}-{self.scheme}")

    def tearDown(self):
        complaints = [line for line in self.hand.page.complaints() if "422" not in line]
        self.assertEqual(complaints, [])
        self.assertLessEqual(self.hand.run("return document.documentElement.scrollWidth"), self.width)

    def test_joints_of_segments_are_dragged(self):
        hand = self.open(PROGRAM_SCENE)
        self.assertEqual(hand.handles(), [f"Joint of segments {i} and {i + 1}" for i in range(1, 6)])
        angles = lambda: [hand.shown(f"motion.segments[{i}].angle_deg") for i in range(6)]
        before = angles()
        hand.drag("Joint of segments 2 and 3", 24, 0)
        self.assertGreater(angles()[1], before[1])
        self.assertAlmostEqual(angles()[1] + angles()[2], before[1] + before[2])
        self.assertEqual(angles()[3:], before[3:])
        self.assertEqual(hand.shown("motion.segments[1].to_mm"), 10, "a level drag leaves the height")
        hand.drag("Joint of segments 3 and 4", 0, 24)
        self.assertLess(hand.shown("motion.segments[1].to_mm"), 10, "a dwell keeps what the stroke before it reaches")
        self.assertEqual(hand.fault(), "")
        self.assertLess(hand.distance("Joint of segments 3 and 4", ""), 0.1)
        self.picture("joints")
        hand.click("[data-control=undo]")
        hand.click("[data-control=undo]")
        self.assertEqual(angles(), before)

    def test_a_valve_has_its_own_handles(self):
        hand = self.open(SCENES / "valve_intake.toml")
        self.assertEqual(hand.handles(), ["Nose", "End of the duration"])
        self.assertEqual(hand.run("return document.querySelectorAll('[data-edit=add-point]').length"), 0)
        self.assertLess(hand.distance("Nose", ""), 0.1)
        self.assertLess(hand.distance("End of the duration", ""), 0.1)
        duration, lift = (hand.shown(f"motion.{key}") for key in ("duration_crank_deg", "lift_mm"))
        hand.drag("End of the duration", 8, 0)
        self.assertGreater(hand.shown("motion.duration_crank_deg"), duration)
        hand.drag("Nose", 0, 8)
        self.assertLess(hand.shown("motion.lift_mm"), lift)
        self.assertEqual(hand.fault(), "")

    def test_set_points_are_added_dragged_and_removed(self):
        hand = self.open(POINTS)
        count = sum("set point" in one for one in hand.handles())
        hand.click('.group[data-table=motion] [data-edit=add-point]')
        self.assertEqual(hand.fault(), "")
        words, table = f"set point {count + 1}", f"motion.via[{count}]"
        self.assertIn(f"Set point {count + 1}", hand.groups())
        self.assertLess(hand.distance(words, ""), 0.1)
        at, height = hand.shown(f"{table}.at_deg"), hand.shown(f"{table}.displacement_mm")
        hand.drag(words, 16, -12)
        self.assertGreater(hand.shown(f"{table}.at_deg"), at)
        self.assertGreater(hand.shown(f"{table}.displacement_mm"), height)
        self.assertLess(hand.distance(words, ""), 0.15)
        self.picture("set-points")
        hand.click(f'.group[data-table="{table}"] [data-edit=remove]')
        self.assertNotIn(words, hand.handles())
        self.assertFalse(hand.has(f'.group[data-table="{table}"]'))

    def test_segments_are_added_and_removed(self):
        hand = self.open(PROGRAM_SCENE)
        segments = lambda: sum(one.startswith("Segment") and "," not in one for one in hand.groups())
        angles = lambda: [hand.shown(f"motion.segments[{i}].angle_deg") for i in range(segments())]
        whole = angles()
        hand.click('.group[data-table="motion.segments[1]"] [data-edit=add-dwell]')
        self.assertEqual((hand.fault(), angles()), ("", [40, 35, 35, 40, 70, 40, 100]))
        hand.click('.group[data-table="motion.segments[2]"] [data-edit=remove]')
        self.assertEqual((hand.fault(), angles()), ("", whole))
        hand.click('.group[data-table="motion.segments[3]"] [data-edit=add-stroke]')
        self.assertEqual((hand.fault(), angles()), ("", [40, 70, 40, 35, 35, 40, 100]))
        self.assertEqual(hand.shown("motion.segments[4].to_mm"), 18)
        hand.drag("Joint of segments 4 and 5", 0, 10)
        self.assertEqual(hand.fault(), "")
        hand.click('.group[data-table="motion.segments[1]"] [data-edit=add-point]')
        self.assertEqual(hand.fault(), "")
        self.assertIn("Set point 1 of segment 2", hand.groups())
        self.picture("segments")
        while hand.run("return !document.querySelector('[data-control=undo]').disabled"):
            hand.click("[data-control=undo]")
        self.assertEqual(angles(), whole)

    def test_labels_are_words(self):
        hand = self.open(PROGRAM_SCENE)
        labels = hand.run("return [...document.querySelectorAll('.control [aria-label]')].map((one) => one.getAttribute('aria-label'))")
        self.assertIn("Segment 1: cam angle, deg", labels)
        seen = hand.run("return [...document.querySelectorAll('.group > summary, .control-name, .add-key option, .downloads button')].map((one) => one.textContent)")
        self.assertIn("Segment 1", seen)
        self.assertIn("Largest pressure angle, deg", seen)
        for words in labels + seen:
            self.assertNotRegex(words, r"[_\[\]]|[a-z]\.[a-z]", words)
        hand.find('.group[data-table="limits"]')
        self.picture("labels")

    def test_units_are_chosen_and_typed(self):
        hand = self.open(PROGRAM_SCENE)
        hand.write("cam.base_radius_mm", "1.25 in")
        self.assertEqual((hand.fault(), hand.shown("cam.base_radius_mm")), ("", 31.75))
        hand.write("cam.base_radius_mm", "2 lb", answered=False)
        self.assertEqual(hand.fault(), 'Base radius, mm: found "2 lb"; allowed: a number in mm, or a number with one of the units mm, in, m.')
        self.assertEqual(hand.shown("cam.base_radius_mm"), 31.75)
        self.picture("refused-unit")
        hand.choose("[data-control=units]", "in")
        self.assertEqual(hand.fault(), "")
        self.assertEqual(hand.shown("cam.base_radius_in"), 1.25)
        self.assertEqual(hand.run("return Camopt.page.data.curves[0].unit"), "in")
        hand.write("cam.base_radius_in", "28 mm")
        self.assertAlmostEqual(hand.shown("cam.base_radius_in"), 28 / 25.4, places=8)
        hand.drag("Joint of segments 2 and 3", 0, 16)
        self.assertEqual(hand.fault(), "")
        self.assertLess(hand.shown("motion.segments[1].to_in"), 10 / 25.4)
        self.picture("inches")
        hand.choose("[data-control=units]", "mm")
        self.assertEqual(hand.shown("cam.base_radius_mm"), 28)

    def test_files_are_downloaded(self):
        hand = self.open(PROGRAM_SCENE)
        hand.run("document.querySelector('.downloads').scrollIntoView()")
        self.picture("downloads")
        files = {"drawing_pdf": "drawing.pdf", "drawing_svg": "drawing.svg", "drawing_dxf": "drawing.dxf", "step": "cam.step", "nc": "cam.nc", "plc": "codesys.st"}
        for name, file in files.items():
            if not hand.has(f'[data-download-file="{name}"]'):
                self.assertIn(name, ("drawing_pdf", "step"), "only a library may be missing")
                continue
            hand.click(f'[data-download-file="{name}"]', answered=False)
            path = self.downloads / file
            wait_for(file, lambda one=path: one.exists() and one.stat().st_size > 0, 60)
            self.assertEqual(hand.fault(), "")


class ByMouseInTheDark(ByMouse):
    scheme = "dark"


class OnAPhone(ByMouse):
    width = 390


class OnAPhoneInTheDark(ByMouse):
    width, scheme = 390, "dark"


if not hasattr(unittest.TestCase, "enterContext"):  # Python 3.10
    def enter_context(self, context):
        value = context.__enter__()
        self.addCleanup(context.__exit__, None, None, None)
        return value
    unittest.TestCase.enterContext = enter_context

if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]], verbosity=2)
