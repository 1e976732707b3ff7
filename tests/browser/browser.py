# SPDX-License-Identifier: MIT
"""Headless Chromium for the tests of pages: start it, open a file, wait, look. Skips loudly where it is not there."""

import base64
import contextlib
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
ARGUMENTS = ("--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
             "--disable-component-update", "--disable-sync", "--window-size=1440,1000")
# Three dimensions drawn by the processor: slow, also for all that is flat.
SOLIDS = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
FLAT = ("--disable-gpu",)


def skip(missing):
    print(f"SKIPPED: {missing} is not installed, so no page was opened in a browser. "
          "Debian: apt-get install chromium chromium-driver python3-selenium")
    sys.exit(SKIPPED)


def open_browser(downloads=None, arguments=SOLIDS):
    """A driver with the console's log on; `downloads`: the folder into which files go; `arguments`: more of them."""
    try:
        from selenium import webdriver
        from selenium.webdriver.chrome.options import Options
        from selenium.webdriver.chrome.service import Service
    except ImportError:
        skip("python3-selenium")
    program = shutil.which("chromium") or shutil.which("google-chrome")
    driver = shutil.which("chromedriver")
    if not program:
        skip("chromium")
    if not driver:
        skip("chromium-driver")
    options = Options()
    options.binary_location = program
    for argument in (*ARGUMENTS, *arguments):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    if downloads:
        options.add_experimental_option("prefs", {
            "download.default_directory": str(downloads),
            "profile.default_content_setting_values.automatic_downloads": 1})
    return webdriver.Chrome(options=options, service=Service(driver))


@contextlib.contextmanager
def browser_of(width=1440, scheme="light", downloads=None, arguments=()):
    """A fresh browser for as long as it is used, for pages without three dimensions."""
    driver = open_browser(downloads, (*FLAT, *arguments))
    try:
        page = Page(driver)
        page.width(width)
        page.media(scheme)
        yield page
    finally:
        driver.quit()


def wait_for(what, condition, seconds=20.0):
    """The condition's value once it is true."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise AssertionError(f"waited {seconds:g} s for {what}")
        time.sleep(0.05)


class Page:
    """A page in the browser."""

    def __init__(self, driver):
        self.driver = driver

    def open(self, path):
        self.driver.get(pathlib.Path(path).resolve().as_uri())
        wait_for("the page to be ready", lambda: self.js("return document.documentElement.dataset.ready === 'true'"))

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def settle(self):
        """Two frames: what was asked for is drawn."""
        self.driver.execute_async_script("const done = arguments[0]; "
                                         "requestAnimationFrame(() => requestAnimationFrame(() => done()));")

    def media(self, scheme):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                    {"features": [{"name": "prefers-color-scheme", "value": scheme}]})

    def width(self, pixels):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": pixels, "height": 900, "deviceScaleFactor": 1, "mobile": pixels < 600})

    def pdf(self):
        printed = self.driver.execute_cdp_cmd("Page.printToPDF", {"printBackground": True, "preferCSSPageSize": True})
        return base64.b64decode(printed["data"])

    def complaints(self):
        """What the console has to say since it was asked last."""
        return [f"{entry['level']}: {entry['message']}" for entry in self.driver.get_log("browser")
                if entry["level"] in ("SEVERE", "WARNING")]


def run_camopt(program, *words):
    """What it prints. Exit codes 0 (a motion) and 3 (proved infeasible) are results."""
    result = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    if result.returncode not in (0, 3):
        raise AssertionError(f"camopt {' '.join(map(str, words))}: {result.returncode}\n{result.stderr}")
    return result.stdout


def run_tests(tests, prepare, arguments=SOLIDS):
    """Each test gets (page, what `prepare` made in a folder of its own). Every one runs; faults are told at the end."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        downloads = folder / "downloads"
        downloads.mkdir()
        driver = open_browser(downloads, arguments)
        faults = 0
        try:
            made = prepare(folder)
            for test in tests:
                page = Page(driver)
                try:
                    test(page, made)
                    complaints = page.complaints()
                    assert not complaints, f"the console says {complaints}"
                    print(f"passed  {test.__name__}")
                except AssertionError as fault:
                    faults += 1
                    print(f"FAILED  {test.__name__}: {fault}")
        finally:
            driver.quit()
    print(f"{len(tests) - faults} of {len(tests)} passed")
    sys.exit(1 if faults else 0)
