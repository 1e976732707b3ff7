# SPDX-License-Identifier: MIT
"""kernel_test.py SESSION WORK: the C++ kernel as Jupyter starts it. Exit status 77 where a package is missing."""

import os
import pathlib
import shutil
import sys
import threading
import time
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2] / "notebooks_cpp" / "kernel"
sys.path.insert(0, str(SOURCE))
SECONDS = 60


def skip(words):
    print(f"SKIPPED: {words}; the notebooks' kernel was not tested")
    sys.exit(77)


if not shutil.which(os.environ.get("CAMOPT_CLANG_REPL", "clang-repl-22")):
    skip("no clang-repl-22 (Debian's package clang-tools-22, of the security suite)")
try:
    import ipykernel  # noqa: F401
    from jupyter_client.manager import KernelManager
except ImportError as missing:
    skip(f"no Python module {missing.name} (python3-ipykernel, python3-jupyter-client)")

import install_kernel  # noqa: E402


class Answer:
    """What a cell did."""

    def __init__(self):
        self.status, self.streams, self.data, self.error = "", {"stdout": "", "stderr": ""}, [], None


class KernelTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        install_kernel.install(SESSION, WORK)
        os.environ["JUPYTER_PATH"] = str(pathlib.Path(WORK) / "share" / "jupyter")
        cls.manager = KernelManager(kernel_name=install_kernel.NAME)
        cls.manager.start_kernel()
        cls.client = cls.manager.client()
        cls.client.start_channels()
        cls.client.wait_for_ready(timeout=SECONDS)

    @classmethod
    def tearDownClass(cls):
        cls.client.stop_channels()
        cls.manager.shutdown_kernel(now=False)

    def run_cell(self, code):
        answer = Answer()

        def hear(message):
            content = message["content"]
            if message["msg_type"] == "stream":
                answer.streams[content["name"]] += content["text"]
            elif message["msg_type"] == "display_data":
                answer.data.append(content["data"])
            elif message["msg_type"] == "error":
                answer.error = content

        # A failing cell is wanted here: what is asked right after it must not be dropped as its follower.
        reply = self.client.execute_interactive(code, timeout=SECONDS, output_hook=hear, allow_stdin=False,
                                                stop_on_error=False)
        answer.status = reply["content"]["status"]
        return answer

    def works(self, code):
        answer = self.run_cell(code)
        self.assertEqual(answer.status, "ok", answer.error)
        return answer

    def fails(self, code, kind):
        answer = self.run_cell(code)
        self.assertEqual(answer.status, "error")
        self.assertEqual(answer.error["ename"], kind)
        return answer

    def test_info(self):
        info = self.client.kernel_info(reply=True, timeout=SECONDS)["content"]["language_info"]
        self.assertEqual((info["name"], info["mimetype"]), ("C++", "text/x-c++src"))

    def test_output_of_both_streams(self):
        answer = self.works('#include <iostream>\nstd::cout << 6 * 7 << std::endl;\nstd::cerr << "aside" << std::endl;')
        self.assertEqual(answer.streams, {"stdout": "42\n", "stderr": "aside\n"})

    def test_value_of_an_expression(self):
        self.works("int of_expression = 20;")
        self.assertIn("(int) 21", self.works("of_expression + 1").streams["stdout"])

    def test_utf_8(self):
        text = "grüß: β ≤ 30° ✓"
        answer = self.works(f'#include <iostream>\nfor (char c : std::string("{text}")) std::cout << c << std::flush;')
        self.assertEqual(answer.streams["stdout"], text)

    def test_compile_error_has_the_line_of_the_cell(self):
        answer = self.fails("int fine = 1;\nint wrong = nowhere;", "CompileError")
        self.assertIn("line 2, column 13: error: use of undeclared identifier 'nowhere'", answer.error["evalue"])
        self.assertNotIn("input_line", "".join(answer.error["traceback"]))

    def test_bracket_that_is_never_closed(self):
        """clang-repl alone would wait for its partner for ever."""
        answer = self.fails("int a_1 = 1;\nvoid f_1() {\n    a_1 = 2;", "CompileError")
        self.assertIn("line 2: error: '{' is never closed", answer.error["evalue"])

    def test_compile_error_takes_nothing_along(self):
        """Include guards, names and instantiated templates are as before."""
        self.works("#include <map>\n#include <string>\n#include <vector>\n#include <iostream>\n"
                   "struct Thing { std::string name; };")
        code = 'std::map<int, std::vector<Thing>> things;\nthings[1].push_back({"one"});\n'
        self.fails("#include <deque>\n" + code + "int wrong = nowhere;", "CompileError")
        answer = self.works("#include <deque>\nstd::deque<int> d(3);\n" + code +
                            "std::cout << things[1][0].name << d.size();")
        self.assertEqual(answer.streams["stdout"], "one3")

    def test_exception_is_shown_and_the_cell_taken_back(self):
        self.works("#include <stdexcept>\nint kept = 1;")
        answer = self.fails('kept = 2;\nint later = 3;\nthrow std::out_of_range("too far");', "std::out_of_range")
        self.assertEqual(answer.error["evalue"], "too far")
        self.assertIn("(int) 5", self.works("int later = 4;\nkept + later").streams["stdout"])

    def test_exception_that_is_no_std_exception(self):
        self.fails("throw 3;", "int")

    def test_abort_and_crash_leave_the_session(self):
        self.works("#include <cstdlib>\nint before_crash = 8;")
        self.assertIn("signal 6", self.fails("std::abort();", "Aborted").error["evalue"])
        self.assertIn("signal 11", self.fails("*(volatile int*)0 = 1;", "Aborted").error["evalue"])
        self.fails("int deep(int n) { volatile int a[1000]; a[0] = n; return deep(n + 1) + a[0]; }\ndeep(0);", "Aborted")
        self.fails("std::exit(3);", "Aborted")
        self.assertIn("(int) 8", self.works("before_crash").streams["stdout"])

    def test_function_that_is_nowhere_defined(self):
        answer = self.fails("void nowhere_defined(int);\nnowhere_defined(1);", "CompileError")
        self.assertIn("Symbols not found", "".join(answer.error["traceback"]))
        self.works("int after_link_error = 1;")

    def test_runs_from_top_to_bottom_with_constants(self):
        answer = self.works("#include <iostream>\nint step = 1;\nstep = 2;\nconst int seen = [] { return step; }();\n"
                            "step = 3;\nstd::cout << seen << step;")
        self.assertEqual(answer.streams["stdout"], "23")

    def test_lambda_in_a_statement(self):
        answer = self.works("#include <algorithm>\n#include <iostream>\n#include <vector>\nstd::vector<int> v = {2, 3, 1};\n"
                            "std::sort(v.begin(), v.end(), [](int a, int b) { return a > b; });\n"
                            "for (int i : v) std::cout << i;")
        self.assertEqual(answer.streams["stdout"], "321")

    def test_rich_display(self):
        picture = '<svg xmlns="http://www.w3.org/2000/svg"><style>.a,.b{fill:red}</style><title>größer</title></svg>'
        answer = self.works('#include "notebooks_cpp/display.hpp"\n#include <iostream>\nstd::cout << "before ";\n'
                            f'notebook::display_svg(R"({picture})");\n'
                            'notebook::Table({"a", "b"}).row({"<x>", notebook::fixed(1.0 / 3, 3)}).show();\n'
                            'std::cout << "after";')
        self.assertEqual(answer.streams["stdout"], "before after")
        self.assertEqual([sorted(data) for data in answer.data],
                         [["image/svg+xml", "text/plain"], ["text/html", "text/plain"]])
        svg = answer.data[0]["image/svg+xml"]
        self.assertIn("größer", svg)
        self.assertIn("#picture-1 .a,#picture-1 .b{fill:red}", svg)  # its rules are its own
        html = answer.data[1]["text/html"]
        self.assertIn("&lt;x&gt;", html)
        self.assertIn("0.333", html)

    def interrupted(self, code):
        timer = threading.Timer(1.5, self.manager.interrupt_kernel)
        timer.start()
        begin = time.monotonic()
        answer = self.fails(code, "Interrupted")
        self.assertLess(time.monotonic() - begin, 30)
        return answer

    def test_interrupt_of_a_loop_without_end(self):
        self.works("int before_loop = 5;")
        self.interrupted("before_loop = 6;\nfor (;;) {}")
        self.assertIn("(int) 5", self.works("before_loop").streams["stdout"])

    def test_interrupt_that_the_cell_hears(self):
        self.works('#include "notebooks_cpp/display.hpp"\n#include <iostream>')
        answer = self.interrupted('int rounds = 0;\nwhile (!notebook::interrupted()) ++rounds;\nstd::cout << "ended";')
        self.assertEqual(answer.streams["stdout"], "ended")
        self.assertIn("true", self.works("rounds > 0").streams["stdout"])


if __name__ == "__main__":
    SESSION, WORK = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
