# SPDX-License-Identifier: MIT
"""camopt studio by plain HTTP: what it answers, what it refuses, and that it ends.

usage: studio_http_test.py CAMOPT SCENES"""
import json
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "browser"))
from studio import command_line, studio  # noqa: E402

PROGRAM, SCENES = sys.argv[1], pathlib.Path(sys.argv[2])
DRD = SCENES / "drd_cubic_32.toml"
CAM = SCENES / "cam_roller.toml"
JSON = {"Content-Type": "application/json"}
# Many starts of a search that is not convex: minutes of work.
LONG = (SCENES / "drd_torque.toml").read_text() + """
[solver]
gap = 1e-12
starts = 100000
max_seconds = 600
"""


class Served(unittest.TestCase):
    """One studio for all that does not end it."""

    @classmethod
    def setUpClass(cls):
        cls.running = studio(PROGRAM, DRD)
        cls.studio = cls.running.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.running.__exit__(None, None, None)


class Answers(Served):
    def test_the_page_is_there_and_says_what_may_run(self):
        status, body, headers = self.studio.ask("GET", "")
        self.assertEqual(status, 200)
        self.assertIn(b"page-data", body)
        policy = headers["Content-Security-Policy"]
        nonce = policy.split("'nonce-")[1].split("'")[0]
        self.assertRegex(nonce, "^[0-9a-f]{32}$")
        self.assertIn(f'<script nonce="{nonce}">'.encode(), body)
        for part in ("default-src 'none'", "connect-src 'self'", "frame-ancestors 'none'", "base-uri 'none'"):
            self.assertIn(part, policy)
        self.assertNotIn("unsafe-inline' 'nonce", policy)
        self.assertEqual(headers["Cache-Control"], "no-store")
        self.assertEqual(headers["Referrer-Policy"], "no-referrer")
        self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
        self.assertEqual(headers["Cross-Origin-Resource-Policy"], "same-origin")
        again = self.studio.ask("GET", "")[2]["Content-Security-Policy"]
        self.assertNotEqual(again, policy, "each page has a nonce of its own")

    def test_a_solve_is_that_of_the_command_line(self):
        for scene, settings in ((DRD, {}), (DRD, {"objective.velocity": 0.7}), (CAM, {"cam.base_radius_mm": 18})):
            status, answer = self.studio.solve(scene.read_text(), set=settings)
            self.assertEqual(status, 200, answer)
            there = command_line(PROGRAM, scene, *(f"{key}={value}" for key, value in settings.items()))
            self.assertEqual(answer["verdict"], there["verdict"])
            self.assertAlmostEqual(answer["objective"], there["objective"], delta=1e-8)

    def test_a_warm_solve_is_that_of_the_command_line_too(self):
        for value in (0.3, 0.35, 0.42):
            _, answer = self.studio.solve(CAM.read_text(), set={"objective.velocity": value})
        there = command_line(PROGRAM, CAM, "objective.velocity=0.42")
        self.assertEqual(answer["verdict"], there["verdict"])
        self.assertAlmostEqual(answer["objective"], there["objective"], delta=1e-8)

    def test_a_curve_is_near_and_claims_nothing(self):
        _, answer = self.studio.solve(CAM.read_text(), stage="curve")
        self.assertAlmostEqual(answer["objective"], command_line(PROGRAM, CAM)["objective"], delta=1e-5)
        data = answer["data"]
        self.assertEqual((answer["stage"], answer["more"], data["verdict"]["tone"]), ("curve", False, "open"))
        self.assertIn("Not proved yet", data["verdict"]["headline"])
        self.assertEqual((data["tables"], data["lists"], data["reference"], data["appendix"]["sentences"]), ([], [], None, []))

    def test_a_curve_of_a_search_goes_on_from_the_last_motion(self):
        scene = (SCENES / "cam_arm_flat.toml").read_text()
        _, proved = self.studio.solve(scene, page="arm", stage="proof")
        _, seen = self.studio.solve(scene, page="arm", stage="curve", set={"objective.velocity": 0.41})
        there = command_line(PROGRAM, SCENES / "cam_arm_flat.toml", "objective.velocity=0.41")
        self.assertEqual(proved["verdict"], "optimal")
        self.assertEqual(seen["verdict"], "local")
        self.assertAlmostEqual(seen["objective"], there["objective"], delta=1e-5)

    def test_the_rest_follows_the_proof_without_another_solve(self):
        text = CAM.read_text()
        _, proof = self.studio.solve(text, set={"objective.velocity": 0.33}, stage="proof")
        _, rest = self.studio.solve(text, set={"objective.velocity": 0.33}, stage="rest")
        self.assertTrue(proof["more"])
        self.assertFalse(rest["more"])
        self.assertEqual(proof["seconds"], rest["seconds"])
        self.assertEqual(proof["data"]["tables"], rest["data"]["tables"])
        self.assertEqual(proof["data"]["reference"]["sentences"], ["Being compared …"])
        self.assertIn("worse in the objective", rest["data"]["reference"]["sentences"][0])
        _, alone = self.studio.solve(text, set={"objective.velocity": 0.34}, stage="rest")
        self.assertNotEqual(alone["seconds"], rest["seconds"])
        self.assertEqual(alone["verdict"], "optimal")

    def test_controls_follow_the_scene(self):
        _, answer = self.studio.solve(CAM.read_text(), set={"limits.cam_radius_min_mm": None, "motion.speed_rpm": 240})
        controls = {f"{one['table']}.{one['key']}": one for one in answer["controls"]}
        self.assertEqual(controls["cam.base_radius_mm"]["value"], 16)
        self.assertEqual(controls["cam.base_radius_mm"]["unit"], "mm")
        self.assertTrue(controls["cam.base_radius_mm"]["may_range"])
        self.assertFalse(controls["limits.cam_radius_min_mm"]["given"])
        self.assertEqual(controls["motion.speed_rpm"]["value"], 240)
        self.assertEqual(controls["spline.degree"]["choices"], [3, 5, 7])
        self.assertNotIn("limits.torque_nm", controls, "a limit on forces needs [forces]")
        self.assertNotIn("cam_radius_min", answer["scene"])

    def test_a_part_of_an_answer_is_the_whole(self):
        status, body, _ = self.studio.ask("GET", "", headers={"Range": "bytes=0-9,20-30"})
        self.assertEqual((status, body[:9]), (200, b"<!DOCTYPE"))

    def test_laws_beside(self):
        _, answer = self.studio.solve(DRD.read_text(), laws=["cycloidal", "simple_harmonic"])
        cycloidal = answer["laws"][0]
        angles = answer["data"]["angle"]["values"]
        self.assertEqual(len(cycloidal["curves"]["velocity"]), len(angles))
        self.assertAlmostEqual(max(cycloidal["curves"]["displacement"]), 1.0, places=6)
        self.assertAlmostEqual(cycloidal["peaks"]["velocity"], 2.0, places=6)
        status, answer = self.studio.solve(DRD.read_text(), laws=["no_law"])
        self.assertEqual(status, 422)
        self.assertIn("no_law", answer["error"])

    def test_infeasible_scenes_are_explained_when_asked(self):
        scene = (SCENES / "infeasible_velocity_cap.toml").read_text()
        _, answer = self.studio.solve(scene)
        self.assertEqual(answer["verdict"], "infeasible")
        _, explained = self.studio.solve(scene, stage="rest")
        self.assertGreater(len(json.dumps(explained["data"])), len(json.dumps(answer["data"])))

    def test_downloads(self):
        body = {"page": "test", "scene": CAM.read_text(), "set": {"cam.base_radius_mm": 18}}
        first = {"scene": b"title", "motion": b"theta_deg,", "cam": b"theta_deg,", "dxf": b"  0\n", "result": b"{",
                 "report": b"<!DOCTYPE html>"}
        for what, beginning in first.items():
            status, text, headers = self.studio.post("export", {**body, "what": what})
            self.assertEqual(status, 200, what)
            self.assertTrue(text.startswith(beginning), (what, text[:40]))
            self.assertTrue(headers["Content-Disposition"].startswith('attachment; filename="'))
            self.assertEqual(headers["Content-Security-Policy"], "default-src 'none'; frame-ancestors 'none'")
        # Of a cam that closes: drawings, solid, program, controller tables. No file stays behind.
        before = set(pathlib.Path(tempfile.gettempdir()).glob("camopt-*"))
        whole = {"page": "test", "scene": (SCENES / "cam_drdrd.toml").read_text()}
        available = self.studio.solve(whole["scene"])[1]["downloads"]
        beginnings = {"drawing_pdf": b"%PDF-", "drawing_svg": b"<", "drawing_dxf": b"  0\n", "step": b"ISO-10303-21", "nc": b"%", "plc_codesys": b"// camopt"}
        for what in sorted(set(beginnings) & set(available)):
            status, text, _ = self.studio.post("export", {**whole, "what": what})
            self.assertEqual(status, 200, (what, text[:200]))
            self.assertTrue(text.startswith(beginnings[what]), (what, text[:40]))
        self.assertEqual(set(pathlib.Path(tempfile.gettempdir()).glob("camopt-*")), before)
        self.assertGreaterEqual(set(available), {"drawing_svg", "drawing_dxf", "nc", "plc_codesys"})
        self.assertEqual(self.studio.post("export", {**whole, "scene": DRD.read_text(), "what": "nc"})[0], 422, "no cam")
        scene = self.studio.post("export", {**body, "what": "scene"})[1].decode()
        self.assertIn("base_radius_mm = 18", scene)
        self.assertEqual(self.studio.post("export", {**body, "what": "../../etc/passwd"})[0], 422)
        self.assertEqual(self.studio.post("export", {**body, "scene": DRD.read_text(), "set": {}, "what": "dxf"})[0], 422)


class Refusals(Served):
    def refused(self, status, method, target, body=None, headers=None):
        found, text, answered = self.studio.ask_raw(method, target, body, headers)
        self.assertEqual(found, status, (method, target, headers))
        self.assertEqual(text, b"refused\n")
        self.assertNotIn(self.studio.token.encode(), text)
        self.assertFalse([name for name in answered if name.lower().startswith("access-control-")])

    def good(self):
        return json.dumps({"page": "x", "scene": DRD.read_text()})

    def test_foreign_hosts(self):
        page = f"/{self.studio.token}/"
        for host in ("evil.example", f"evil.example:{self.studio.port}", f"localhost:{self.studio.port}", "127.0.0.1",
                     f"127.0.0.1:{self.studio.port + 1}", f"127.0.0.1:{self.studio.port}.evil.example", ""):
            self.refused(403, "GET", page, headers={"Host": host})

    def test_foreign_origins(self):
        target, body = f"/{self.studio.token}/solve", self.good()
        for origin in ("http://evil.example", "null", f"http://localhost:{self.studio.port}",
                       f"http://127.0.0.1:{self.studio.port + 1}", f"https://127.0.0.1:{self.studio.port}"):
            self.refused(403, "POST", target, body, {**JSON, "Origin": origin})
        for site in ("cross-site", "same-site"):
            self.refused(403, "GET", f"/{self.studio.token}/", headers={"Sec-Fetch-Site": site})
        own = {**JSON, "Origin": f"http://127.0.0.1:{self.studio.port}", "Sec-Fetch-Site": "same-origin"}
        self.assertEqual(self.studio.ask("POST", "solve", body, own)[0], 200)

    def test_wrong_tokens_and_targets(self):
        token = self.studio.token
        for target in ("/", "/index.html", f"/{'0' * 32}/", f"/{token}", f"/{token[:-1]}/", f"/{token}/x", f"/{token}/../",
                       f"/{token}/?x=1", f"/%{ord(token[0]):02x}{token[1:]}/", f"//{token}/", f"/{token}/solve/",
                       "/" + "a" * 5000):
            self.refused(404, "GET", target)
        self.refused(404, "POST", f"/{'f' * 32}/solve", self.good(), JSON)

    def test_wrong_methods(self):
        token = self.studio.token
        for method in ("POST", "PUT", "DELETE", "OPTIONS", "PATCH"):
            self.refused(405, method, f"/{token}/", "" if method != "OPTIONS" else None)
        self.refused(405, "GET", f"/{token}/solve")
        self.refused(405, "OPTIONS", f"/{token}/solve",
                     headers={"Access-Control-Request-Method": "POST"})
        self.assertEqual(self.studio.ask("HEAD", "")[0], 405)

    def test_unfit_bodies(self):
        target = f"/{self.studio.token}/solve"
        self.refused(415, "POST", target, self.good(), {"Content-Type": "text/plain"})
        self.refused(415, "POST", target, self.good(), {"Content-Type": "application/x-www-form-urlencoded"})
        self.refused(415, "POST", target, self.good(), {"Content-Type": "multipart/form-data; boundary=x"})
        self.refused(415, "POST", target, self.good(), {**JSON, "Content-Encoding": "gzip"})
        self.refused(413, "POST", target, "x" * 1_100_000, JSON)
        self.refused(413, "POST", target, "", {**JSON, "Content-Length": "9" * 30})
        self.refused(400, "POST", target, "", {**JSON, "Content-Length": "-1"})
        self.refused(411, "POST", target, iter([b"{}"]), {**JSON, "Transfer-Encoding": "chunked"})

    def test_bad_requests(self):
        for body in ("", "{", "[]", "7", '{"page": "x"}', '{"page": 7, "scene": ""}', "\xff\xfe", "[" * 100000,
                     json.dumps({"page": "x" * 65, "scene": ""}),
                     json.dumps({"page": "x", "scene": "", "set": []}),
                     json.dumps({"page": "x", "scene": "", "set": {f"a{i}": 1 for i in range(201)}}),
                     json.dumps({"page": "x", "scene": "", "laws": "all"}),
                     json.dumps({"page": "x", "scene": "", "stage": "quick"})):
            status, text, _ = self.studio.ask("POST", "solve", body.encode("latin-1"), JSON)
            self.assertEqual(status, 400, (body[:60], text))
            self.assertIn("error", json.loads(text))

    def test_bad_scenes(self):
        scene = DRD.read_text()
        for text, settings, words in (
                ("[motion", {}, "scene:1:"),
                (scene.replace("segments = 32", "segments = -3"), {}, "segments"),
                (scene, {"spline.segment": 3}, "segments"),
                (scene, {"spline.segments": 0}, "spline.segments"),
                (scene, {"spline.segments": [1]}, "found a value of another kind"),
                (scene, {"motion.lift_mm": {"min": 1}}, "found a value of another kind"),
                (scene + '\n[include]\nfile = "/etc/passwd"\n', {}, "include"),
                (scene + '\n[measured]\ntable = "/etc/passwd"\n', {}, "measured"),
                (scene, {"measured.table": "/etc/passwd"}, "measured"),
                ("[" * 5000, {}, "scene:1:"),
                (scene, {"a.b]=\n": 1}, "error")):
            status, answer = self.studio.solve(text, set=settings)
            self.assertEqual(status, 422, answer)
            self.assertIn(words, json.dumps(answer))
            self.assertNotIn("root:", json.dumps(answer))

    def raw(self, text, seconds=15.0):
        with socket.create_connection(("127.0.0.1", self.studio.port), timeout=seconds) as line:
            line.sendall(text)
            answer = b""
            try:
                while chunk := line.recv(65536):
                    answer += chunk
            except ConnectionResetError:
                pass
            return answer

    def test_requests_that_are_none(self):
        host = f"Host: 127.0.0.1:{self.studio.port}\r\n"
        page = f"/{self.studio.token}/"
        self.assertIn(b" 403 ", self.raw(f"GET {page} HTTP/1.1\r\n\r\n".encode()).split(b"\r\n")[0])
        self.assertIn(b" 403 ", self.raw(f"GET {page} HTTP/1.1\r\n{host}Host: evil.example\r\n\r\n".encode()).split(b"\r\n")[0])
        twice = f"POST {page}solve HTTP/1.1\r\n{host}Content-Type: application/json\r\nContent-Length: 2\r\nContent-Length: 3\r\n\r\n{{}}x"
        self.assertIn(b" 400 ", self.raw(twice.encode()).split(b"\r\n")[0])
        for text in (b"\0\1\2\3\r\n\r\n", b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"\x16\x03\x01\x02\x00\x01\x00\r\n\r\n"):
            self.assertNotIn(b" 200 ", self.raw(text).split(b"\r\n")[0])

    def test_one_request_a_connection(self):
        host = f"Host: 127.0.0.1:{self.studio.port}\r\n"
        one = f"GET /{self.studio.token}/ HTTP/1.1\r\n{host}\r\n"
        answer = self.raw((f"GET /x HTTP/1.1\r\n{host}\r\n" + one).encode())
        self.assertEqual(answer.count(b"HTTP/1.1 "), 1)
        self.assertIn(b" 404 ", answer.split(b"\r\n")[0])

    def test_headers_without_end(self):
        begun = time.monotonic()
        self.raw(b"GET / HTTP/1.1\r\n" + b"X-A: b\r\n" * 400_000, 30.0)
        self.assertLess(time.monotonic() - begun, 25.0)
        self.assertEqual(self.studio.ask("GET", "")[0], 200)

    def test_64_half_open_connections_do_not_delay_the_page(self):
        held = [socket.create_connection(("127.0.0.1", self.studio.port)) for _ in range(64)]
        try:
            for line in held[::2]:
                line.sendall(b"GET / HTTP/1.1\r\nHost: 127")
            begun = time.monotonic()
            self.assertEqual(self.studio.ask("GET", "")[0], 200)
            self.assertLess(time.monotonic() - begun, 3.0)
            for line in held:  # and each of them is closed in the end, whatever it has sent
                line.settimeout(20.0)
                try:
                    self.assertEqual(line.recv(100), b"")
                except ConnectionResetError:
                    pass
            self.assertLess(time.monotonic() - begun, 15.0)
        finally:
            for line in held:
                line.close()

    def test_slow_clients_hold_nobody_up(self):
        held = [socket.create_connection(("127.0.0.1", self.studio.port)) for _ in range(12)]
        try:
            for line in held:
                line.sendall(b"GET / HT")
            begun = time.monotonic()
            self.assertEqual(self.studio.solve(DRD.read_text())[0], 200)
            self.assertLess(time.monotonic() - begun, 9.0)
            # A byte now and then does not prolong it: the request as a whole has its time.
            ended = None
            while ended is None and time.monotonic() - begun < 25.0:
                time.sleep(0.5)
                try:
                    held[0].sendall(b"T")
                    held[0].settimeout(0.01)
                    if held[0].recv(1024):
                        ended = time.monotonic() - begun
                except TimeoutError:
                    continue
                except OSError:
                    ended = time.monotonic() - begun
            self.assertIsNotNone(ended, "a slow client was not sent away")
        finally:
            for line in held:
                line.close()


class Newest(Served):
    def test_a_newer_request_cancels_the_older_one(self):
        found = {}

        def older():
            found["status"], found["answer"] = self.studio.solve(LONG)

        thread = threading.Thread(target=older)
        begun = time.monotonic()
        thread.start()
        time.sleep(0.5)
        status, answer = self.studio.solve(DRD.read_text())
        thread.join()
        self.assertEqual((status, answer["verdict"]), (200, "optimal"))
        self.assertEqual(found["status"], 409, found["answer"].get("verdict"))
        self.assertLess(time.monotonic() - begun, 9.0)

    def test_a_solve_ends_by_the_clock(self):
        begun = time.monotonic()
        status, _ = self.studio.solve(LONG, timeout=90)
        self.assertEqual(status, 200)
        self.assertGreater(time.monotonic() - begun, 5.0, "the scene was meant to take long")
        self.assertLess(time.monotonic() - begun, 40.0)


class Ending(unittest.TestCase):
    def test_signals_end_it_at_once_and_cancel_solves(self):
        for name in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with studio(PROGRAM) as running:
                thread = threading.Thread(target=lambda one=running: self.ask_in_vain(one))
                thread.start()
                held = socket.create_connection(("127.0.0.1", running.port))
                time.sleep(0.7)
                begun = time.monotonic()
                running.process.send_signal(name)
                self.assertEqual(running.process.wait(20), 0, name)
                self.assertLess(time.monotonic() - begun, 8.0, name)
                thread.join()
                held.close()
                with self.assertRaises(OSError):
                    socket.create_connection(("127.0.0.1", running.port), timeout=2)

    @staticmethod
    def ask_in_vain(running):
        try:
            running.solve(LONG)
        except (OSError, ValueError):
            pass

    def test_it_is_bound_to_the_loopback_alone(self):
        with studio(PROGRAM) as running:
            listening = pathlib.Path("/proc/net/tcp").read_text().split("\n")
            own = [line.split()[1] for line in listening if f":{running.port:04X} " in line and line.split()[3] == "0A"]
            self.assertEqual(own, [f"0100007F:{running.port:04X}"])

    def test_a_taken_port_is_told(self):
        with studio(PROGRAM) as running:
            run = subprocess.run([PROGRAM, "studio", "--port", str(running.port)], capture_output=True, text=True,
                                 timeout=30, check=False)
            self.assertEqual(run.returncode, 2)
            self.assertIn("taken", run.stderr)

    def test_tokens_differ(self):
        with studio(PROGRAM) as first, studio(PROGRAM) as second:
            self.assertNotEqual(first.token, second.token)

    def test_a_wrong_scene_is_told_before_anything_is_served(self):
        run = subprocess.run([PROGRAM, "studio", str(DRD), "--set", "spline.segments=0"], capture_output=True,
                             text=True, timeout=30, check=False)
        self.assertEqual(run.returncode, 2)
        self.assertIn("spline.segments", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
