# SPDX-License-Identifier: MIT
"""The studio as a program of its own, and plain HTTP to it."""
import contextlib
import http.client
import json
import re
import select
import signal
import subprocess


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
