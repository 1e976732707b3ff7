# SPDX-License-Identifier: MIT
"""The running studio, plain HTTP to it, and its page in a browser."""
import contextlib
import http.client
import json
import re
import select
import signal
import subprocess

from browser import wait_for


class Studio:
    """What a running `camopt studio` said of itself."""

    def __init__(self, process, line):
        found = re.search(r"http://127\.0\.0\.1:(\d+)/([0-9a-f]{32})/", line)
        if not found:
            raise AssertionError(f"no address in the first line: {line!r}")
        self.process, self.address = process, found[0]
        self.port, self.token = int(found[1]), found[2]

    def ask(self, method, what, body=None, headers=None, timeout=30):
        """status, body, headers of one request; `what` stands behind the token."""
        return self.ask_raw(method, f"/{self.token}/{what}", body, headers, timeout)

    def ask_raw(self, method, target, body=None, headers=None, timeout=30):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        try:
            connection.request(method, target, body, headers or {})
            answer = connection.getresponse()
            return answer.status, answer.read(), dict(answer.getheaders())
        finally:
            connection.close()

    def post(self, what, body, timeout=60):
        status, text, headers = self.ask("POST", what, json.dumps(body), {"Content-Type": "application/json"}, timeout)
        return status, text, headers

    def solve(self, scene, timeout=60, **more):
        status, text, _ = self.post("solve", {"page": "test", "scene": scene, **more}, timeout)
        return status, json.loads(text)


def command_line(program, scene, *settings):
    """The result of camopt solve."""
    arguments = [word for setting in settings for word in ("--set", setting)]
    run = subprocess.run([program, "solve", str(scene), "--json", *arguments], capture_output=True, text=True, check=False)
    return json.loads(run.stdout)


@contextlib.contextmanager
def studio(program, *arguments):
    process = subprocess.Popen([program, "studio", *map(str, arguments)], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    try:
        ready, _, _ = select.select([process.stdout], [], [], 60)
        line = process.stdout.readline() if ready else ""
        if not line:
            raise AssertionError(f"camopt studio said nothing: {process.stderr.read() if process.poll() else ''}")
        yield Studio(process, line)
    finally:
        if process.poll() is None:
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(30)
            except subprocess.TimeoutExpired:
                process.kill()
                raise
        process.stdout.close()
        process.stderr.close()


class StudioPage:
    """The studio's page in a browser, by what a user sees and moves."""

    pictures = None  # folder for screenshots

    def __init__(self, page, address):
        self.page, self.driver, self.run = page, page.driver, page.js
        self.driver.get(address)
        wait_for("the page", lambda: self.run("return document.documentElement.dataset.studio === 'ready'"), 90)

    def settled(self):
        return int(self.run("return document.documentElement.dataset.settled || '0'"))

    def after(self, act):
        """Waits until what was asked by `act` is answered and drawn."""
        before = self.settled()
        act()
        wait_for("an answer", lambda: self.settled() > before, 90)

    def move(self, key, value):
        """A slider, as a hand moves it."""
        self.after(lambda: self.run("""
            const slider = document.querySelector(`[data-key="${arguments[0]}"] input[type=range]`);
            slider.value = arguments[1];
            slider.dispatchEvent(new Event('input'));
            slider.dispatchEvent(new Event('change'));""", key, str(value)))

    def type(self, key, value):
        self.after(lambda: self.run("""
            const field = document.querySelector(`[data-key="${arguments[0]}"] input.number`);
            field.value = arguments[1];
            field.dispatchEvent(new Event('change'));""", key, str(value)))

    def click(self, selector):
        self.run("document.querySelector(arguments[0]).click()", selector)

    def shown(self, key):
        return float(self.run('return document.querySelector(`[data-key="${arguments[0]}"] input.number`).value', key))

    def objective(self):
        return float(self.run("return document.querySelector('.headline').dataset.objective"))

    def write(self, key, text, leave=True):
        """As by keyboard: the field has the focus, and what it had is replaced."""
        from selenium.webdriver.common.keys import Keys
        field = self.driver.find_element("css selector", f'[data-key="{key}"] input.number')
        self.run("arguments[0].focus(); arguments[0].select()", field)
        field.send_keys(Keys.DELETE, text, *([Keys.ENTER] if leave else []))
        return field

    def differences(self):
        """Fields, sliders, choices and ticks that do not show what the scene holds."""
        return self.run("""
            return Camopt.studio.answer.controls.filter((one) => one.given).flatMap((one) => {
                const path = Camopt.controlPath(one), row = document.querySelector(`[data-key="${CSS.escape(path)}"]`);
                const wanted = one.type === 'range' ? [one.value.min, one.value.max] : [one.value];
                const shown = [...row.querySelectorAll('input.number')].map((field) => field.value);
                const found = shown.length ? shown.map(Number) : row.querySelector('select') ? [row.querySelector('select').value]
                    : row.querySelector('input[type=checkbox]') ? [row.querySelector('input[type=checkbox]').checked] : [row.querySelector('input[type=text]:not(.number)').value];
                const slider = row.querySelector('input[type=range]');
                const right = found.length === wanted.length && found.every((text, i) => String(text) === String(wanted[i]) && shown[i] !== '');
                const placed = !slider || Math.abs(Number(slider.value) - one.value) <= 1e-12 * Math.abs(one.value);
                return right && placed ? [] : [path + ': ' + found + (slider ? ', slider ' + slider.value : '') + '; the scene holds ' + wanted];
            });""")

    def use(self, text):
        self.after(lambda: self.run("""document.querySelector('.editor textarea').value = arguments[0];
                    document.querySelector('[data-control=use-scene]').click();""", text))

    def fault(self):
        return self.run("return document.querySelector('.fault').textContent")

    def picture(self, name):
        if self.pictures:
            self.pictures.mkdir(parents=True, exist_ok=True)
            self.driver.save_screenshot(str(self.pictures / f"{name}.png"))
