# SPDX-License-Identifier: MIT
"""report.html in a browser: it loads, says nothing on the console, reads what motion.csv has, moves the follower.

    report_page_test.py CAMOPT SCENES SOLVED (solve_examples.py)
"""

import csv
import pathlib
import re
import sys

import browser

DISK, LINKAGE, DRUM, HOPELESS = "cam_forces", "tappet_75", "cylinder_slide", "cam_infeasible"
GROOVE, DISKS, GUIDE = "cam_grooved", "cam_conjugate", "inverse_feeder"
KINDS = (DISK, LINKAGE, DRUM, HOPELESS, GROOVE, DISKS, GUIDE)


def prepare(folder):
    solved, scenes = pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[2])
    pusher, knife = scenes.parent / "tests/cases/wrong_conflict.toml", scenes / "machines/knife.toml"
    browser.run_camopt(sys.argv[1], "solve", pusher, "--out", folder / "pusher")
    limits = [word for limit in ("pressure_angle_deg=18", "contact_force_min_n=150", "acceleration_m_s2=4") for word in ("--set", "limits." + limit)]
    browser.run_camopt(sys.argv[1], "solve", pusher, *limits, "--out", folder / "impossible")
    browser.run_camopt(sys.argv[1], "machine", knife, "--set", "machine.speed_rpm=100", "--out", folder / "machine")
    return {"downloads": folder / "downloads", **{name: solved / name for name in KINDS},
            **{name: folder / name for name in ("pusher", "impossible", "machine")}}


def number(text):
    """The first number of a read-out: '811.8 mm/s  (12.9 mm/rad)'."""
    return float(text.split()[0].replace("−", "-"))


def all_kinds_load(page, made):
    for name in KINDS:
        page.open(made[name] / "report.html")
        assert page.js("return document.querySelector('h1').textContent.length") > 0, name
        assert not page.complaints(), name


def nothing_is_asked_for_from_elsewhere(page, made):
    page.open(made[DISK] / "report.html")
    asked = page.js("return performance.getEntriesByType('resource').map((one) => one.name)")
    assert not asked, asked


def cursor_reads_motion_csv(page, made):
    page.open(made[DISK] / "report.html")
    with open(made[DISK] / "motion.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    columns = {"displacement": ("s_mm", 1.0), "velocity": ("v_mm_s", 1.0), "acceleration": ("a_mm_s2", 1e-3)}
    for place in (0.13, 0.37, 0.62):
        for key, (column, factor) in columns.items():
            plot = page.driver.find_element("css selector", f"[data-curve={key}] .u-over")
            page.js("arguments[0].scrollIntoView({block: 'center'})", plot)
            from selenium.webdriver.common.action_chains import ActionChains
            width = plot.size["width"]
            ActionChains(page.driver).move_to_element_with_offset(plot, round((place - 0.5) * width), 0).perform()
            page.settle()
            angle = page.js("return Camopt.page.angle.at")
            assert angle > 0, "the cursor did not move"
            shown = page.js("return document.querySelector(arguments[0]).textContent", f"[data-curve={key}] .read-out")
            near = [float(row[column]) * factor for row in rows if abs(float(row["theta_deg"]) - angle) < 1e-5]
            if not near:  # in the dwell after the motion
                assert abs(number(shown)) < 1e-6, shown
                continue
            assert min(abs(number(shown) - value) for value in near) <= 2e-5 * max(map(abs, near)) + 1e-9, \
                f"{key} at {angle}: {shown}, motion.csv has {near}"


def marks_are_those_of_the_table(page, made):
    page.open(made[DISK] / "report.html")
    data = page.js("return JSON.parse(document.getElementById('page-data').textContent)")
    peaks = {row[0]: row for table in data["tables"] if table["key"] == "peaks" for row in table["rows"]}
    for curve in data["curves"]:
        if curve["key"] in peaks and curve["marks"]:
            at = float(peaks[curve["key"]][2])
            assert abs(curve["marks"][0]["at"] - at) <= 1e-4 * max(1.0, at), (curve["key"], at)


def animation_moves_the_follower(page, made):
    for name in (DISK, LINKAGE, DRUM):
        page.open(made[name] / "report.html")
        pose = "const one = document.querySelector('.drawing:not([hidden]), .solid:not([hidden])'); " \
               "return one.dataset.turned"
        before = page.js(pose)
        page.js("document.querySelector('.play').click()")
        browser.wait_for(f"the cam of {name} to turn", lambda: page.js(pose) != before)
        if name != DRUM:
            place = "return [...document.querySelectorAll('.drawing .roller')].map((one) => one.getAttribute('transform'))"
            first = page.js(place)
            browser.wait_for(f"the roller of {name} to move", lambda: page.js(place) != first)
        page.js("document.querySelector('.play').click()")
        page.settle()
        still = page.js(pose)
        page.settle()
        assert page.js(pose) == still, "it goes on after a pause"


def slider_and_keys_set_the_angle(page, made):
    from selenium.webdriver.common.keys import Keys
    page.open(made[DISK] / "report.html")
    slider = page.driver.find_element("css selector", "input.angle")
    slider.send_keys(Keys.ARROW_RIGHT * 5)
    assert abs(page.js("return Camopt.page.angle.at") - 5.0) < 1e-9
    plot = page.driver.find_element("css selector", "[data-curve=velocity] .plot")
    before = page.js("return Camopt.page.angle.index")
    page.js("arguments[0].focus()", plot)
    plot.send_keys(Keys.ARROW_RIGHT)
    assert page.js("return Camopt.page.angle.index") == before + 1
    plot.send_keys(Keys.END)
    assert page.js("return Camopt.page.angle.at") == 360
    assert page.js("return document.querySelector('.angle-now').textContent") == "360.0°"


def curves_are_switched_off_and_on(page, made):
    page.open(made[DISK] / "report.html")
    chip = "document.querySelector('[data-chip=jerk]')"
    page.js(f"{chip}.click()")
    assert page.js("return document.querySelector('[data-curve=jerk]').hidden")
    assert page.js(f"return {chip}.getAttribute('aria-pressed')") == "false"
    page.js(f"{chip}.click()")
    assert not page.js("return document.querySelector('[data-curve=jerk]').hidden")


def every_picture_has_a_table(page, made):
    page.open(made[DISK] / "report.html")
    charts = page.js("return document.querySelectorAll('.chart').length")
    assert charts >= 10, charts
    rows = page.js("const one = document.querySelector('[data-curve=velocity] details'); one.open = true; "
                   "one.dispatchEvent(new Event('toggle')); return one.querySelectorAll('tbody tr').length")
    assert rows > 30, rows
    unnamed = page.js("return [...document.querySelectorAll('[role=img], button, input, select')].filter((one) => "
                      "!one.getAttribute('aria-label') && !one.textContent.trim()).length")
    assert unnamed == 0, f"{unnamed} pictures or controls without a name"


def light_and_dark(page, made):
    background = "return getComputedStyle(document.body).backgroundColor"
    page.open(made[DISK] / "report.html")
    page.media("light")
    light = page.js(background)
    page.media("dark")
    browser.wait_for("dark colours", lambda: page.js(background) != light)
    page.js("document.querySelector('[data-control=theme]').click()")
    assert page.js(background) == light, "the button does not overrule the system"
    page.js("localStorage.clear()")
    page.media("light")


def nothing_scrolls_sideways_on_a_telephone(page, made):
    for width in (390, 1440):
        page.width(width)
        for name in KINDS:
            page.open(made[name] / "report.html")
            wide = page.js("return document.documentElement.scrollWidth")
            assert wide <= width, f"{name} is {wide} pixels wide on {width}"
    page.width(1440)


def prints(page, made):
    for name in (DISK, DRUM):
        page.open(made[name] / "report.html")
        pdf = page.pdf()
        assert pdf.startswith(b"%PDF") and len(pdf) > 40_000, (name, len(pdf))
        assert not page.js("return Camopt.isPrinting()"), "it stays in its printed shape"


def charts_begin_on_the_first_printed_page(page, made):
    """Ranges, too, follow the height of a printed chart: labels find their room."""
    page.open(made[DISK] / "report.html")
    pages = len(re.findall(rb"/Type /Page\b", page.pdf()))
    assert pages <= 4, f"{pages} pages of paper"
    range_of = "const scale = Camopt.page.charts.charts.get('velocity').plot.scales.y; return [scale.min, scale.max]"
    screen = page.js(range_of)
    page.js("Camopt.printing.send(true)")
    page.settle()
    paper = page.js(range_of)
    page.js("Camopt.printing.send(false)")
    page.settle()
    assert paper[1] > screen[1], (screen, paper)
    assert page.js(range_of) == screen


def charts_have_two_dots_a_pixel(page, made):
    page.open(made[DISK] / "report.html")
    dots = page.js("return [...document.querySelectorAll('.plot canvas')].map((one) => one.width / one.getBoundingClientRect().width)")
    assert len(dots) >= 10 and min(dots) > 1.9, dots


def labels_keep_off_lines_of_limits(page, made):
    """The torque's peak stands just below its limit: its label is not struck through."""
    page.open(made[DISK] / "report.html")
    limit = page.js("const plot = Camopt.page.charts.charts.get('torque').plot; return plot.valToPos("
                    "Camopt.page.charts.charts.get('torque').curve.limits[0].at, 'y', true)")
    page.js("""
        window.written = [];
        const context = Camopt.page.charts.charts.get('torque').plot.ctx;
        context.fillText = function (text, x, y) { window.written.push([text, y]); };
        Camopt.page.charts.charts.get('torque').plot.redraw();""")
    page.settle()
    written = page.js("return window.written")
    peaks = [top for text, top in written if " at " in text]
    assert peaks, written
    for top in peaks:
        assert not top < limit < top + 22, f"the limit at {limit} runs through the label from {top}"


def labels_keep_off_curves(page, made):
    for width in (1440, 390):
        page.width(width)
        page.open(made["pusher"] / "report.html")
        for key in ("pressure_angle", "torque", "hertz_pressure", "acceleration"):
            hidden = page.js("""
                const plot = Camopt.page.charts.charts.get(arguments[0]).plot, written = [];
                const context = plot.ctx, fill = context.fillText.bind(context);
                context.fillText = (text, x, y) => { if (text.includes(' at ')) written.push([text, x, y, context.measureText(text).width]); fill(text, x, y); };
                plot.redraw();
                return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(written.filter(([text, x, y, width]) =>
                  plot.data[0].some((at, row) => {
                    const left = plot.valToPos(at, 'x', true), top = plot.valToPos(plot.data[1][row], 'y', true);
                    return left > x && left < x + width && top > y && top < y + 9 * devicePixelRatio;
                  }))))));""", key)
            assert not hidden, (width, key, hidden)
    page.width(1440)


def what_is_needed_is_not_cut_off(page, made):
    for width in (1440, 390):
        page.width(width)
        page.open(made["impossible"] / "report.html")
        wide, room = page.js("const box = document.querySelector('[data-table=changes] .table-scroll'); return [box.scrollWidth, box.clientWidth]")
        assert wide <= room + 1, (width, wide, room)
    page.width(1440)


def headings_have_something_below(page, made):
    for name in ("machine", DISK, HOPELESS):
        page.open(made[name] / "report.html")
        empty = page.js("""return [...document.querySelectorAll('h2, h3')].filter((one) => one.getClientRects().length &&
            one.parentNode.textContent.trim() === one.textContent.trim() && !one.parentNode.querySelector('canvas, svg')).map((one) => one.textContent)""")
        assert not empty, (name, empty)
    assert page.js("return document.querySelectorAll('ul:empty').length") == 0


def pictures_of_cams_are_whole(page, made):
    """Nothing of a drawing, the arrow of its turn included, leaves its frame."""
    for name in (DISK, LINKAGE, GROOVE, DISKS, GUIDE):
        page.open(made[name] / "report.html")
        outside = page.js("""
            const frame = document.querySelector('.drawing svg').getBoundingClientRect();
            return [...document.querySelectorAll('.drawing svg path, .drawing svg circle, .drawing svg text')].filter((one) => {
              const box = one.getBoundingClientRect();
              return box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1;
            }).map((one) => one.getAttribute('class') || one.parentNode.getAttribute('class'))""")
        assert not outside, f"{name}: {outside}"
    page.open(made[GROOVE] / "report.html")
    assert page.js("return getComputedStyle(document.querySelector('.drawing .grooved')).fillRule") == "evenodd"
    page.open(made[DISKS] / "report.html")
    first, second = page.js("return [...document.querySelectorAll('.drawing .cam, .drawing .second')].map((one) => getComputedStyle(one).stroke)")
    assert first != second, "both disks have one colour"


def the_scene_is_handed_out(page, made):
    page.open(made[DISK] / "report.html")
    page.driver.execute_cdp_cmd("Browser.setDownloadBehavior",
                                {"behavior": "allow", "downloadPath": str(made["downloads"])})
    page.js("document.querySelector('[data-download=scene]').click()")
    file = made["downloads"] / f"{DISK}.toml"
    browser.wait_for("the download", file.exists)
    browser.wait_for("the whole file", lambda: file.read_text() == (made[DISK] / "scene.toml").read_text())


if __name__ == "__main__":
    browser.run_tests([all_kinds_load, nothing_is_asked_for_from_elsewhere, cursor_reads_motion_csv,
                       marks_are_those_of_the_table, animation_moves_the_follower, slider_and_keys_set_the_angle,
                       curves_are_switched_off_and_on, every_picture_has_a_table, light_and_dark,
                       nothing_scrolls_sideways_on_a_telephone, prints, charts_begin_on_the_first_printed_page,
                       charts_have_two_dots_a_pixel, labels_keep_off_lines_of_limits, labels_keep_off_curves,
                       what_is_needed_is_not_cut_off, headings_have_something_below, pictures_of_cams_are_whole,
                       the_scene_is_handed_out], prepare)
