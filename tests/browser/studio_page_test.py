# SPDX-License-Identifier: MIT
"""camopt studio in a headless browser, from slider to curve, and what a hostile page gets of it.

usage: studio_page_test.py CAMOPT SCENES [FOLDER for screenshots]"""
import contextlib
import http.server
import json
import pathlib
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from browser import browser_of, wait_for  # noqa: E402
from studio import StudioPage, command_line, studio  # noqa: E402

PROGRAM, SCENES = sys.argv[1], pathlib.Path(sys.argv[2])
PICTURES = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
StudioPage.pictures = PICTURES
DRD, CAM = SCENES / "drd_cubic_32.toml", SCENES / "cam_roller.toml"


class OnePage(unittest.TestCase):
    """One studio and one browser for all; the page is opened anew for each."""

    @classmethod
    def setUpClass(cls):
        cls.ends = contextlib.ExitStack()
        cls.downloads = cls.ends.enter_context(tempfile.TemporaryDirectory())
        cls.studio = cls.ends.enter_context(studio(PROGRAM, cls.scene))
        cls.browser = cls.ends.enter_context(browser_of(downloads=cls.downloads))

    @classmethod
    def tearDownClass(cls):
        cls.ends.close()

    def setUp(self):
        self.page = StudioPage(self.browser, self.studio.address)

    def tearDown(self):
        self.assertEqual(self.page.page.complaints(), [])


class CamScene(OnePage):
    scene = CAM

    def test_a_slider_solves_as_the_command_line_does(self):
        page = self.page
        self.assertAlmostEqual(page.objective(), command_line(PROGRAM, CAM)["objective"], delta=1e-8)
        page.move("cam.base_radius_mm", 18)
        there = command_line(PROGRAM, CAM, "cam.base_radius_mm=18")
        self.assertAlmostEqual(page.objective(), there["objective"], delta=1e-8)
        self.assertEqual(page.shown("cam.base_radius_mm"), 18)
        peak = max(filter(None, page.run("return Camopt.page.data.curves.find((one) => one.key === 'velocity').values")))
        self.assertAlmostEqual(peak, 20 / (80 * 3.141592653589793 / 180) * there["peaks"]["velocity"]["value"], delta=1e-4)

    def test_the_curve_comes_first_and_says_that_it_is_not_proved(self):
        page = self.page
        page.run("""
            window.seen = [];
            const look = () => {
                const head = document.querySelector('.headline'), words = document.querySelector('.words');
                window.seen.push({stage: head.dataset.stage, text: head.textContent, outdated: words.classList.contains('outdated'),
                                  tables: document.querySelector('.tables').classList.contains('outdated'),
                                  note: getComputedStyle(words, '::before').content});
            };
            new MutationObserver(look).observe(document.querySelector('.headline'), {attributes: true, attributeFilter: ['data-stage']});""")
        page.move("objective.velocity", 0.55)
        seen = page.run("return window.seen")
        self.assertEqual([one["stage"] for one in seen], ["curve", "proof", "rest"])
        for one in seen:
            open_ = one["stage"] == "curve"
            self.assertEqual(one["text"], "Not proved yet" if open_ else "The best motion, and proved optimal")
            self.assertEqual((one["outdated"], one["tables"]), (open_, open_))
            self.assertEqual("Not proved yet" in one["note"], open_)
        times = page.run("return Camopt.studio.times")
        self.assertEqual([one["stage"] for one in times], ["curve", "proof", "rest"])
        self.assertEqual(sorted(one["ms"] for one in times), [one["ms"] for one in times])
        self.assertIn("worse in the objective", page.run("return document.querySelector('.against').textContent"))

    def test_a_slider_in_the_hand_draws_curves_and_its_release_proves_the_last(self):
        page = self.page
        for value in (0.45, 0.5, 0.6):
            page.after(lambda one=value: page.run("""
                const slider = document.querySelector('[data-key="objective.velocity"] input[type=range]');
                slider.value = arguments[0];
                slider.dispatchEvent(new Event('input'));""", str(one)))
            self.assertEqual(page.run("return document.querySelector('.headline').dataset.stage"), "curve")
        page.after(lambda: page.run("""
            document.querySelector('[data-key="objective.velocity"] input[type=range]').dispatchEvent(new Event('change'));"""))
        self.assertEqual([one["stage"] for one in page.run("return Camopt.studio.times")], ["curve"] * 3 + ["proof", "rest"])
        self.assertAlmostEqual(page.objective(), command_line(PROGRAM, CAM, "objective.velocity=0.6")["objective"], delta=1e-8)

    def test_cursor_and_animation(self):
        page = self.page
        for row in (40, 120):
            page.run("Camopt.page.angle.setRow(arguments[0])", row)
            curve = page.run("return Camopt.page.data.curves.find((one) => one.key === 'displacement')")
            text = page.run("return document.querySelector('[data-curve=displacement] .read-out').textContent")
            self.assertAlmostEqual(float(text.split()[0].replace("−", "-")), curve["values"][row], delta=1e-4)
        first = page.run("return Camopt.page.angle.at")
        page.run("Camopt.page.angle.play(true)")
        wait_for("the cam to turn", lambda: page.run("return Camopt.page.angle.at") != first)
        page.run("Camopt.page.angle.play(false)")

    def test_undo_redo_add_and_leave_out(self):
        page = self.page
        start = page.objective()
        self.assertTrue(page.run("return document.querySelector('[data-control=undo]').disabled"))
        page.move("objective.velocity", 0.7)
        moved = page.objective()
        self.assertGreater(abs(moved - start), 1e-3)
        page.after(lambda: page.click('[data-key="limits.cam_radius_min_mm"] .away'))
        self.assertIsNone(page.run("return document.querySelector('[data-key=\"limits.cam_radius_min_mm\"]')"))
        page.after(lambda: page.click("[data-control=undo]"))
        self.assertEqual(page.shown("limits.cam_radius_min_mm"), 4)
        page.after(lambda: page.run("document.body.dispatchEvent(new KeyboardEvent('keydown', {key: 'z', ctrlKey: true, bubbles: true}))"))
        self.assertAlmostEqual(page.objective(), start, delta=1e-8)
        self.assertEqual(page.shown("objective.velocity"), 0.4)
        page.after(lambda: page.click("[data-control=redo]"))
        self.assertAlmostEqual(page.objective(), moved, delta=1e-8)
        # A key with a default begins with it; one without asks for its number.
        page.run("""const select = document.querySelector('[data-add=limits]');
                    select.value = 'limits.concave_radius_min_mm'; select.dispatchEvent(new Event('change'));""")
        page.after(lambda: page.run("""const field = document.querySelector('[data-table=limits] .new-value input');
                    field.value = '12'; field.dispatchEvent(new Event('change'));"""))
        self.assertEqual(page.shown("limits.concave_radius_min_mm"), 12)

    def test_a_dimension_becomes_a_range(self):
        page = self.page
        page.after(lambda: page.click('[data-key="cam.base_radius_mm"] [aria-pressed=false]'))
        ends = page.run("""return [...document.querySelectorAll('[data-key="cam.base_radius_mm"] input')].map((one) => one.value)""")
        self.assertEqual(ends, ["8", "24"])
        self.assertRegex(page.run("return document.querySelector('.editor textarea').value"),
                         r"base_radius_mm = \{ ?min = 8(\.0)?, max = 24(\.0)? ?\}")

    def test_what_cannot_be_is_told_and_the_curves_stay(self):
        page = self.page
        page.type("limits.pressure_angle_deg", 95)
        self.assertIn("limits.pressure_angle_deg", page.fault())
        self.assertGreater(page.run("return Camopt.page.data.angle.values.length"), 100)
        self.assertTrue(all("422" in line for line in page.page.complaints()))
        self.assertTrue(page.run("return document.querySelector('[data-control=undo]').disabled"), "nothing was changed")
        page.type("limits.pressure_angle_deg", 10)
        wait_for("the reason", lambda: page.run("return document.querySelector('.verdict').dataset.verdict") == "infeasible")
        wait_for("which change would help", lambda: any(
            "pressure angle" in text for text in page.run("return [...document.querySelectorAll('[data-table] td, .verdict p')].map((one) => one.textContent)")))
        page.after(lambda: page.click("[data-control=undo]"))
        self.assertEqual(page.fault(), "")

    def test_fields_show_what_the_scene_holds(self):
        page = self.page
        self.assertEqual(page.differences(), [])
        for name in ("cam_drdrd", "drd_physical_limits", "cam_smallest", "handbook_nine_points", "cam_arm_roller", "inverse_feeder"):
            page.use((SCENES / f"{name}.toml").read_text())
            self.assertEqual(page.fault(), "", name)
            self.assertEqual(page.differences(), [], name)
        # Between the steps of a slider, far beyond its end and back, next to an end that is not allowed.
        page.use(CAM.read_text())
        for key, value in (("objective.velocity", 0.123456789), ("objective.velocity", 250), ("objective.velocity", 0.4),
                           ("solver.max_seconds", 0.75)):
            if key == "solver.max_seconds":
                page.after(lambda: page.run("Camopt.studio.actions.set('solver.max_seconds', 0.75, false)"))
            else:
                page.type(key, value)
            self.assertEqual(page.shown(key), value)
            self.assertEqual(page.differences(), [], key)

    def test_a_refused_edit_leaves_the_fields_as_the_scene_is(self):
        page = self.page
        page.after(lambda: page.write("limits.pressure_angle_deg", "95"))
        self.assertIn("found 95", page.fault())
        self.assertEqual(page.shown("limits.pressure_angle_deg"), 30)
        self.assertEqual(page.differences(), [])
        self.assertTrue(all("422" in line for line in page.page.complaints()))
        # What is no number was never asked for.
        field = page.write("limits.pressure_angle_deg", "", leave=False)
        page.run("arguments[0].blur()", field)
        self.assertEqual(page.differences(), [])
        # Undo from within the field.
        from selenium.webdriver.common.keys import Keys
        page.after(lambda: page.write("limits.pressure_angle_deg", "25"))
        self.assertEqual(page.shown("limits.pressure_angle_deg"), 25)
        field = page.driver.find_element("css selector", '[data-key="limits.pressure_angle_deg"] input.number')
        page.run("arguments[0].focus()", field)
        page.after(lambda: field.send_keys(Keys.CONTROL, "z"))
        self.assertEqual(page.differences(), [])
        self.assertEqual(page.shown("limits.pressure_angle_deg"), 30)
        # A slider that was drawn into what is refused comes back too, and what it passed is proved.
        page.after(lambda: page.run("Camopt.studio.actions.set('limits.pressure_angle_deg', 28, true)"))
        self.assertEqual(page.run("return document.querySelector('.headline').dataset.stage"), "curve")
        page.after(lambda: page.run("Camopt.studio.actions.set('limits.pressure_angle_deg', 95, true)"))
        self.assertEqual(page.shown("limits.pressure_angle_deg"), 28)
        self.assertEqual(page.run("return document.querySelector('.headline').dataset.stage"), "rest")
        self.assertEqual(page.differences(), [])
        # A text that is refused stays to be mended, and says that it is not in use.
        page.use("[motion]\nlift_mm = -1\n")
        self.assertIn("lift_mm", page.fault())
        self.assertFalse(page.run("return document.querySelector('.unused').hidden"))
        self.assertEqual(page.differences(), [])
        page.use(CAM.read_text())
        self.assertTrue(page.run("return document.querySelector('.unused').hidden"))
        self.assertTrue(all("422" in line for line in page.page.complaints()))

    def test_an_angle_of_a_whole_turn_takes_from_another(self):
        page = self.page
        page.use((SCENES / "cam_drdrd.toml").read_text())
        angles = lambda: [page.shown(f"motion.segments[{i}].angle_deg") for i in range(6)]
        self.assertEqual(angles(), [40, 70, 40, 70, 40, 100])
        page.type("motion.segments[0].angle_deg", 42.5)
        self.assertEqual((page.fault(), angles()), ("", [42.5, 67.5, 40, 70, 40, 100]))
        page.move("motion.segments[5].angle_deg", 104)  # the last takes from the first
        self.assertEqual((page.fault(), angles()), ("", [38.5, 67.5, 40, 70, 40, 104]))
        page.run("""const select = document.querySelector('[data-control=giver]');
                    select.value = 'motion.segments[4].angle_deg'; select.dispatchEvent(new Event('change'));""")
        page.type("motion.segments[1].angle_deg", 70)
        self.assertEqual((page.fault(), angles()), ("", [38.5, 70, 40, 70, 37.5, 104]))
        self.assertEqual(page.differences(), [])
        page.picture("whole_turn")
        page.type("motion.segments[1].angle_deg", 200)  # more than the other has
        self.assertIn("angle_deg", page.fault())
        self.assertEqual(angles(), [38.5, 70, 40, 70, 37.5, 104])
        self.assertTrue(all("422" in line for line in page.page.complaints()))
        page.after(lambda: page.click("[data-control=undo]"))
        self.assertEqual(angles(), [38.5, 67.5, 40, 70, 40, 104])

    def test_without_a_motion_the_last_curves_stay_greyed(self):
        page = self.page
        pictures = "const one = document.querySelector('.pictures'); return [one.hidden, one.classList.contains('of-before')]"
        lines = "return Camopt.page.charts.charts.get('velocity').plot.data[1].length"
        self.assertEqual(page.run(pictures), [False, False])
        before = page.run(lines)
        page.type("limits.pressure_angle_deg", 10)
        wait_for("the verdict", lambda: page.run("return document.querySelector('.verdict').dataset.verdict") == "infeasible")
        self.assertEqual(page.run(pictures), [False, True])
        self.assertEqual(page.run(lines), before)
        page.picture("infeasible")
        page.after(lambda: page.click("[data-law=cycloidal]"))  # nothing to draw beside
        page.after(lambda: page.click("[data-law=cycloidal]"))
        page.after(lambda: page.click("[data-control=undo]"))
        self.assertEqual(page.run(pictures), [False, False])

    def test_laws_beside(self):
        page = self.page
        charts = "return Camopt.page.charts.charts.get('velocity').plot.series.length"
        before = page.run(charts)
        page.after(lambda: page.click("[data-law=cycloidal]"))
        self.assertEqual(page.run(charts), before + 1)
        page.after(lambda: page.click("[data-law=polynomial_345]"))
        self.assertEqual(page.run(charts), before + 2)
        page.move("objective.velocity", 0.6)
        self.assertEqual(page.run(charts), before + 2)
        lengths = page.run("return Camopt.page.charts.charts.get('velocity').plot.data.map((one) => one.length)")
        self.assertEqual(len(set(lengths)), 1, lengths)
        page.picture("laws")
        page.after(lambda: page.click("[data-law=cycloidal]"))
        page.after(lambda: page.click("[data-law=polynomial_345]"))
        self.assertEqual(page.run(charts), before)

    def test_downloads(self):
        page = self.page
        page.move("cam.base_radius_mm", 18)
        for name, file in (("scene", "scene.toml"), ("motion", "motion.csv"), ("dxf", "cam.dxf"), ("report", "report.html")):
            page.click(f'[data-download-file="{name}"]')
            path = pathlib.Path(self.downloads) / file
            wait_for(file, lambda one=path: one.exists() and one.stat().st_size > 0)
        scene = pathlib.Path(self.downloads) / "scene.toml"
        self.assertAlmostEqual(command_line(PROGRAM, scene)["objective"], page.objective(), delta=1e-8)

    def test_a_scene_typed_in(self):
        page = self.page
        page.after(lambda: page.run("""document.querySelector('.editor textarea').value = arguments[0];
                    document.querySelector('[data-control=use-scene]').click();""", DRD.read_text()))
        self.assertAlmostEqual(page.objective(), command_line(PROGRAM, DRD)["objective"], delta=1e-8)
        self.assertIsNone(page.run("return document.querySelector('.group[data-table=cam]')"))
        page.after(lambda: page.click("[data-control=undo]"))
        self.assertAlmostEqual(page.objective(), command_line(PROGRAM, CAM)["objective"], delta=1e-8)


class Narrow(unittest.TestCase):
    def test_nothing_is_wider_than_the_screen(self):
        with studio(PROGRAM, CAM) as running:
            for width, dark in ((1440, False), (1440, True), (390, False), (390, True)):
                with browser_of(width, "dark" if dark else "light") as browser:
                    page = StudioPage(browser, running.address)
                    self.assertLessEqual(page.run("return document.documentElement.scrollWidth"), width)
                    self.assertEqual(page.run("return document.documentElement.dataset.theme"), "dark" if dark else "light")
                    time.sleep(0.5)
                    page.picture(f"studio-{width}-{'dark' if dark else 'light'}")
                    self.assertEqual(browser.complaints(), [])


HOSTILE = """<!doctype html><title>hostile</title><iframe src="ADDRESS"></iframe><script>
const found = {};
async function attempt(name, work) { try { found[name] = await work(); } catch (error) { found[name] = 'refused: ' + error.name; } }
const body = JSON.stringify({page: 'x', scene: SCENE});
(async () => {
  await attempt('page', async () => (await fetch('ADDRESS')).text());
  await attempt('solve', async () => (await fetch('ADDRESSsolve', {method: 'POST', headers: {'Content-Type': 'application/json'}, body})).text());
  await attempt('simple', async () => (await fetch('ADDRESSsolve', {method: 'POST', headers: {'Content-Type': 'text/plain'}, body})).text());
  await attempt('blind', async () => { const answer = await fetch('ADDRESSsolve', {method: 'POST', mode: 'no-cors', body}); return answer.type + (await answer.text()); });
  await attempt('script', () => new Promise((done, fail) => { const one = document.createElement('script'); one.src = 'ADDRESS'; one.onload = () => done('loaded'); one.onerror = () => fail(new Error('no')); document.head.append(one); }));
  await attempt('window', async () => { const other = window.open('ADDRESS'); await new Promise((done) => setTimeout(done, 1500)); return String(other && other.document && other.document.body && other.document.body.textContent.length); });
  await attempt('frame', async () => String(document.querySelector('iframe').contentDocument.body.textContent.length));
  window.found = found;
})();
</script>"""


class Hostile(unittest.TestCase):
    """A page of another origin that even knows the token."""

    def test_it_gets_nothing(self):
        with studio(PROGRAM, DRD) as running:
            text = HOSTILE.replace("ADDRESS", running.address).replace("SCENE", json.dumps(DRD.read_text())).encode()

            class Handler(http.server.BaseHTTPRequestHandler):
                def do_GET(self):
                    self.send_response(200)
                    self.send_header("Content-Type", "text/html")
                    self.end_headers()
                    self.wfile.write(text)

                def log_message(self, *_):
                    pass

            server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
            threading.Thread(target=server.serve_forever, daemon=True).start()
            try:
                for host in ("127.0.0.1", "localhost"):
                    with browser_of() as page:
                        page.driver.get(f"http://{host}:{server.server_port}/")
                        found = wait_for("the attempts", lambda one=page: one.js("return window.found"))
                        for name, what in found.items():
                            with self.subTest(host=host, attempt=name):
                                if name == "window":
                                    self.assertIn(what, ("null", "undefined", "0", "refused: SecurityError", "refused: TypeError"))
                                else:
                                    self.assertTrue(what.startswith("refused"), what[:80])
                        self.assertEqual(set(found), {"page", "solve", "simple", "blind", "script", "window", "frame"})
            finally:
                server.shutdown()
                server.server_close()

    def test_a_name_that_leads_here_gets_nothing(self):
        """DNS rebinding: another name for 127.0.0.1, with the right port and token."""
        with studio(PROGRAM, DRD) as running, browser_of(
                arguments=("--host-resolver-rules=MAP evil.example 127.0.0.1",)) as page:
            page.driver.get(running.address.replace("127.0.0.1", "evil.example"))
            self.assertEqual(page.js("return document.body.textContent").strip(), "refused")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
