# SPDX-License-Identifier: MIT
"""The Jupyter kernel: C++20 cells with camopt, in a session of clang-repl-22 (session.py).

Run by Jupyter with -f CONNECTION_FILE; CAMOPT_NOTEBOOK_SESSION names the session's description.
"""

import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from ipykernel.kernelapp import IPKernelApp  # noqa: E402
from ipykernel.kernelbase import Kernel  # noqa: E402

import session  # noqa: E402


class CppKernel(Kernel):
    implementation = "camopt-cpp"
    implementation_version = "0.4.0"
    language = "C++"
    language_version = "20"
    banner = "C++20 with camopt"
    language_info = {
        "name": "C++",
        "version": "20",
        "mimetype": "text/x-c++src",
        "codemirror_mode": "text/x-c++src",
        "pygments_lexer": "cpp",
        "file_extension": ".cpp",
        "nbconvert_exporter": "script",
    }

    cells = None  # the C++ session

    def do_execute(self, code, silent, store_history=True, user_expressions=None, allow_stdin=False, **_):
        answer = {"execution_count": self.execution_count}
        try:
            if self.cells is None:
                self.cells = session.Session(os.environ["CAMOPT_NOTEBOOK_SESSION"])
            if code.strip():
                self.cells.run(code, (lambda *event: None) if silent else self.tell, self.execution_count)
        except (session.CellError, session.SessionError) as error:
            kind = getattr(error, "kind", "SessionError")
            lines = [line for text in getattr(error, "lines", []) for line in text.splitlines()]
            content = {"ename": kind, "evalue": str(error), "traceback": lines + [f"{kind}: {error}"]}
            if kind == "CompileError":
                content["traceback"] = lines
            if not silent:
                self.send_response(self.iopub_socket, "error", content)
            return {"status": "error", **answer, **content}
        return {"status": "ok", **answer, "payload": [], "user_expressions": {}}

    def tell(self, kind, *rest):
        if kind == "display":
            mime, text = rest
            data = {mime: text, "text/plain": f"[{mime}]"}
            self.send_response(self.iopub_socket, "display_data", {"data": data, "metadata": {}})
        elif rest[0]:
            self.send_response(self.iopub_socket, "stream", {"name": kind, "text": rest[0]})

    def do_shutdown(self, restart):
        if self.cells is not None:
            self.cells.stop()
            self.cells = None
        return {"status": "ok", "restart": restart}


if __name__ == "__main__":
    IPKernelApp.launch_instance(kernel_class=CppKernel)
