# SPDX-License-Identifier: MIT
"""comparison.html, sweep.html and pareto.html in a browser: a pointer names a motion, a click saves its scene.

    studies_page_test.py CAMOPT SCENES
"""

import json
import pathlib
import sys

import browser


def prepare(folder):
    program, scene = sys.argv[1], pathlib.Path(sys.argv[2]) / "drd_cubic_8.toml"
    made = {name: folder / name for name in ("comparison", "sweep", "pareto", "downloads")}
    made["program"] = program
    browser.run_camopt(program, "compare", scene, "--out", made["comparison"])
    browser.run_camopt(program, "sweep", scene, "--weights", "simplex:4", "--out", made["sweep"])
    browser.run_camopt(program, "sweep", scene, "--pareto", "velocity,acceleration", "--points", "5", "--out",
                       made["pareto"])
    return made


PAGES = ("comparison", "sweep", "pareto")


def pages_load_and_fit(page, made):
    for width in (390, 1440):
        page.width(width)
        for name in PAGES:
            page.open(made[name] / f"{name}.html")
            wide = page.js("return document.documentElement.scrollWidth")
            assert wide <= width, f"{name} is {wide} pixels wide on {width}"
            assert not page.complaints(), name


def a_pointer_names_the_motion(page, made):
    from selenium.webdriver.common.action_chains import ActionChains
    for name in PAGES:
        page.open(made[name] / f"{name}.html")
        dot = page.driver.find_elements("css selector", ".scatter .dot")[1]
        page.js("arguments[0].scrollIntoView({block: 'center'})", dot)
        ActionChains(page.driver).move_to_element(dot).perform()
        page.settle()
        # Where several lie on one place the uppermost is meant.
        item = int(page.js("const box = arguments[0].getBoundingClientRect(); return document.elementFromPoint("
                           "box.left + box.width / 2, box.top + box.height / 2).dataset.item", dot))
        names = page.js("return JSON.parse(document.getElementById('page-data').textContent).tables[0].items.names")
        assert page.js("return document.querySelector('.tip strong').textContent") == names[item], name
        assert page.js("return document.querySelectorAll('tr.pointed').length") == 1, name


def marks_of_pictures_are_items(page, made):
    for name in ("sweep", "pareto"):
        page.open(made[name] / f"{name}.html")
        assert page.js("return document.querySelectorAll('.study-picture [data-item]').length") >= 5, name


def a_click_hands_out_a_scene_that_solves(page, made):
    page.driver.execute_cdp_cmd("Browser.setDownloadBehavior",
                                {"behavior": "allow", "downloadPath": str(made["downloads"])})
    for name in PAGES:
        page.open(made[name] / f"{name}.html")
        before = set(made["downloads"].iterdir())
        page.js("document.querySelectorAll('.study-table tbody tr')[1].click()")
        new = browser.wait_for(f"the scene of {name}", lambda: [
            file for file in set(made["downloads"].iterdir()) - before if file.suffix == ".toml"])
        browser.run_camopt(made["program"], "solve", new[0])


def a_law_that_breaks_limits_is_no_reference(page, made):
    scene = pathlib.Path(sys.argv[2]) / "drd_capped_velocity.toml"
    folder = made["comparison"].parent / "capped"
    browser.run_camopt(made["program"], "compare", scene, "--out", folder)
    page.open(folder / "comparison.html")
    scenes = page.js("const motions = Camopt.page.motions; return motions.data.items.tones.map((tone, item) => "
                     "[tone, motions.sceneOf(item)])")
    assert scenes[0][1] == scene.read_text()
    broken = [text for tone, text in scenes if tone == "bad"]
    assert broken and all(text == scene.read_text() for text in broken), "a broken law's scene is another one"
    assert any('reference = "' in text and text != scene.read_text() for tone, text in scenes if tone != "bad"), scenes


def a_page_without_scenes_says_how_to_get_them(page, made):
    scene = pathlib.Path(sys.argv[2]) / "drd_cubic_4.toml"
    folder = made["sweep"].parent / "many"
    browser.run_camopt(made["program"], "sweep", scene, "--weights", "simplex:100", "--out", folder)
    page.open(folder / "sweep.html")
    rows = page.js("return Camopt.page.motions.data.items.names.length")
    assert rows == 5151, rows
    row = page.js("const row = document.querySelectorAll('.study-table tbody tr')[1234]; row.click(); return Number(row.dataset.item)")
    notice = page.js("return document.querySelector('.notice').textContent")
    assert "contains no scenes" in notice, notice
    command = page.js("return document.querySelector('.notice pre').textContent")
    assert command.startswith(f"camopt solve {scene} --set objective.velocity="), command
    solved = browser.run_camopt(made["program"], *command.split()[1:], "--json")
    line = (folder / "sweep.csv").read_text().splitlines()[1 + row].split(",")
    head = (folder / "sweep.csv").read_text().splitlines()[0].split(",")
    objective = json.loads(solved)["objective"]
    assert abs(objective - float(line[head.index("objective")])) < 1e-6, (command, objective, line)
    page.js("[...document.querySelectorAll('.notice button')].find((one) => one.textContent === 'Close').click()")
    assert page.js("return document.querySelector('.notice')") is None
    assert not page.complaints()


def a_head_sorts(page, made):
    page.open(made["comparison"] / "comparison.html")
    page.js("[...document.querySelectorAll('.sort')].find((one) => one.textContent === 'V').click()")
    column = page.js("return [...document.querySelectorAll('.study-table thead th')]"
                     ".findIndex((one) => one.getAttribute('aria-sort') === 'ascending')")
    cells = page.js("return [...document.querySelectorAll('.study-table tbody tr')].map((row) => "
                    "row.cells[arguments[0]].textContent)", column)
    values = [float(cell) for cell in cells if cell]
    assert values == sorted(values) and len(values) > 10, values
    assert cells[:len(values)] == [cell for cell in cells if cell], "laws without a number come last"


def letters_keep_their_size_on_a_telephone(page, made):
    page.width(390)
    for name in PAGES:
        page.open(made[name] / f"{name}.html")
        page.settle()
        heights = page.js("return [...document.querySelectorAll('.scatter text')].map((one) => one.getBBox().height * "
                          "one.ownerSVGElement.clientWidth / one.ownerSVGElement.viewBox.baseVal.width)")
        assert heights and min(heights) > 10, (name, min(heights))
    page.width(1440)


def pictures_turn_dark(page, made):
    for name in ("sweep", "pareto"):
        page.media("dark")
        page.open(made[name] / f"{name}.html")
        look = page.js("return getComputedStyle(document.querySelector('.study-picture svg')).filter")
        page.media("light")
        assert "invert" in look, (name, look)


def light_and_dark(page, made):
    for name in PAGES:
        page.open(made[name] / f"{name}.html")
        page.media("light")
        light = page.js("return getComputedStyle(document.body).backgroundColor")
        page.media("dark")
        browser.wait_for("dark colours", lambda: page.js("return getComputedStyle(document.body).backgroundColor") != light)
        page.media("light")
        assert page.pdf().startswith(b"%PDF")


if __name__ == "__main__":
    browser.run_tests([pages_load_and_fit, a_pointer_names_the_motion, marks_of_pictures_are_items,
                       a_click_hands_out_a_scene_that_solves, a_law_that_breaks_limits_is_no_reference,
                       a_page_without_scenes_says_how_to_get_them, a_head_sorts, letters_keep_their_size_on_a_telephone,
                       pictures_turn_dark, light_and_dark], prepare, browser.FLAT)
