# SPDX-License-Identifier: MIT
"""A headless Chromium for the tests of camopt's pages, by Debian's chromium-driver and python3-selenium."""
import contextlib
import shutil
import sys
import time

SKIPPED = 77


def skip(missing):
    """Ends the test as skipped, and says loudly what is missing."""
    print(f"SKIPPED: the pages are not tested in a browser: {missing} is missing "
          "(Debian: chromium, chromium-driver, python3-selenium)", file=sys.stderr)
    sys.exit(SKIPPED)


try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
except ImportError:
    skip("python3-selenium")
for program in ("chromium", "chromedriver"):
    if shutil.which(program) is None:
        skip(program)


@contextlib.contextmanager
def chromium(width=1440, height=1000, downloads=None, dark=False, extra=()):
    """A fresh browser that forgets everything at the end; extra: words of its command line."""
    options = webdriver.ChromeOptions()
    # The container of a CI has no user namespaces; every page it opens is our own.
    for word in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars",
                 f"--window-size={width},{height}", "--force-device-scale-factor=1", *extra):
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    if downloads:
        options.add_experimental_option("prefs", {
            "download.default_directory": str(downloads),
            "profile.default_content_setting_values.automatic_downloads": 1})
    driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    try:
        driver.set_page_load_timeout(60)
        driver.set_script_timeout(60)
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                               {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})
        yield driver
    finally:
        driver.quit()


def wait_for(what, condition, seconds=30):
    """The value of the condition once it is true; an error that names what was waited for else."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.02)
    raise AssertionError(f"waited {seconds} s in vain for {what}")


def console_faults(driver):
    """What the console holds of errors and warnings since it was last asked."""
    return [entry["message"] for entry in driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]
