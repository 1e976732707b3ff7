# SPDX-License-Identifier: MIT
"""A C++ session: clang-repl-22 over pipes, with camopt loaded. Knows nothing of Jupyter.

What the session is made of stands in a JSON file that the build writes (notebooks_cpp/CMakeLists.txt):
{"preload": "…/libcamopt_notebook_session.so", "libraries": ["…/libcamopt.so"], "flags": ["-I…", …]}.

A cell's output comes as events, in order: ("stdout", text), ("stderr", text), ("display", mime, text). See session.cpp for
how a cell is run, why one that fails takes nothing with it, and the frames on the streams.
"""

import codecs
import json
import os
import pathlib
import re
import selectors
import shutil
import signal
import subprocess
import tempfile
import time

import cell_pieces

CLANG_REPL = os.environ.get("CAMOPT_CLANG_REPL", "clang-repl-22")
INTERRUPT_GRACE = 2.0  # seconds that a cell has to end by itself when it is asked to
FRAME = re.compile(rb"\x1ecamopt (end|display|exception) ([^\n]*)\n")


class SessionError(Exception):
    """The session could not be started."""


class CellError(Exception):
    """A cell that failed: kind (CompileError, an exception's type, …), words, lines to show."""

    def __init__(self, kind, words, lines=()):
        super().__init__(words)
        self.kind, self.words, self.lines = kind, words, list(lines)


class Stream:
    """One of the two pipes: cuts its bytes into text and frames."""

    def __init__(self, name, pipe):
        self.name, self.file = name, pipe
        os.set_blocking(pipe.fileno(), False)
        self.restart()

    def restart(self):
        self.bytes, self.end = b"", None
        self.decoder = codecs.getincrementaldecoder("utf-8")("replace")

    def read(self):
        """False where the pipe has ended."""
        try:
            new = os.read(self.file.fileno(), 1 << 16)
        except BlockingIOError:
            return True
        self.bytes += new
        return bool(new)

    def events(self):
        while self.bytes and self.end is None:
            mark = self.bytes.find(b"\x1e")
            if mark != 0:
                plain, self.bytes = (self.bytes, b"") if mark < 0 else (self.bytes[:mark], self.bytes[mark:])
                yield self.name, self.decoder.decode(plain)
                continue
            frame = FRAME.match(self.bytes)
            if not frame:
                if len(self.bytes) < 200 and b"\n" not in self.bytes:
                    return  # the rest of the head is still to come
                yield self.name, self.decoder.decode(self.bytes[:1])
                self.bytes = self.bytes[1:]
                continue
            kind, words = frame.group(1).decode(), frame.group(2).decode("utf-8", "replace").split()
            if kind == "end":
                self.end, self.bytes = words, self.bytes[frame.end():]
                return
            size = int(words[-1])
            if len(self.bytes) < frame.end() + size:
                return
            payload = self.bytes[frame.end():frame.end() + size].decode("utf-8", "replace")
            self.bytes = self.bytes[frame.end() + size:]
            yield (kind, words[0], payload) if kind == "display" else (kind, payload)


def demangled(text):
    """Names of the linker as in the source, where c++filt is there."""
    if not shutil.which("c++filt"):
        return text
    return subprocess.run(["c++filt"], input=text, capture_output=True, text=True, check=True).stdout


class Session:
    def __init__(self, description):
        self.description = description if isinstance(description, dict) else \
            json.loads(pathlib.Path(description).read_text(encoding="utf-8"))
        self.folder = tempfile.TemporaryDirectory(prefix="camopt-notebook-")
        self.process = None
        self.start()

    def start(self):
        """A fresh session in place of any before."""
        self.stop()
        if not shutil.which(CLANG_REPL):
            raise SessionError(f"{CLANG_REPL} is not installed (Debian 12: package clang-tools-22, security suite)")
        for file in [self.description["preload"], *self.description["libraries"]]:
            if not os.path.exists(file):
                raise SessionError(f"{file} does not exist: scripts/notebooks --install builds it")
        flags = ["-std=c++20", *self.description["flags"]]
        self.process = subprocess.Popen(
            [CLANG_REPL, *(f"-Xcc={flag}" for flag in flags)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, env={**os.environ, "LD_PRELOAD": self.description["preload"]},
            start_new_session=True)  # what interrupts the kernel's process group must not reach it
        self.running, self.count = self.process.pid, 0
        self.streams = [Stream("stdout", self.process.stdout), Stream("stderr", self.process.stderr)]
        for library in self.description["libraries"]:
            self.send(f"%lib {library}")
        words = []
        try:
            self.run("", lambda kind, *rest: words.append(rest[-1]))
        except CellError as error:
            self.stop()
            raise SessionError(f"{CLANG_REPL} does not start: {error.words} {''.join(words)}") from error

    def stop(self):
        if self.process is not None:
            try:
                os.killpg(self.process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            self.process.wait()
            for file in (self.process.stdin, self.process.stdout, self.process.stderr):
                try:
                    file.close()
                except BrokenPipeError:
                    pass
            self.process = None

    def send(self, line):
        self.process.stdin.write(line.encode() + b"\n")
        self.process.stdin.flush()

    def run(self, code, tell, number=None):
        """Runs a cell; tell(kind, …) hears its events. Throws CellError."""
        self.count += 1
        number = self.count if number is None else number
        fault = cell_pieces.bracket_fault(code)
        if fault:
            words = f"cell {number}, line {fault[0]}: error: {fault[1]}"
            raise CellError("CompileError", words, [words])
        paths = []
        for part, text in enumerate(cell_pieces.pieces(code, f"camopt_cell_{self.count}")):
            path = pathlib.Path(self.folder.name) / f"cell-{self.count}-{part}"
            path.write_text(text + "\n", encoding="utf-8")
            paths.append(str(path))
        for stream in self.streams:
            stream.restart()
        errors, failures = [], []  # what came on stderr; exceptions

        def hear(kind, *rest):
            if kind == "exception":
                failures.append(rest[0])
            elif kind == "stderr":
                errors.append(rest[0])
            else:
                tell(kind, *rest)

        try:
            self.send("//camopt cell " + " ".join(paths))
            interrupted = self.wait(hear)
        except (EOFError, BrokenPipeError):
            self.start()
            raise CellError("SessionEnded", "the session ended; a new one has begun, and all cells must be run again",
                            [self.in_cell("".join(errors), number)]) from None
        status, process = self.streams[0].end[:2]
        self.running = int(process)
        self.process.poll()
        text = self.in_cell("".join(errors), number)
        if interrupted and status != "ok":
            raise CellError("Interrupted", "the cell was stopped; everything is as it was before it", [text])
        if status == "compile":
            text = demangled(text)
            first = next((line for line in text.splitlines() if "error:" in line), "does not compile")
            raise CellError("CompileError", first, [text])
        if text.strip():
            tell("stderr", text)
        if status == "exception":
            kind, _, what = failures[-1].partition("\n")
            raise CellError(kind, what)
        if status != "ok":
            words = "the process ended" if status == "ended" else \
                signal.strsignal(int(status.split("-")[1])) + f" (signal {status.split('-')[1]})"
            raise CellError("Aborted", f"{words}; everything is as it was before the cell")
        if interrupted:
            raise CellError("Interrupted", "the cell was asked to stop and ended by itself; what it did is kept")

    def wait(self, hear):
        """Until both streams have told the end of the cell. Returns whether it was interrupted."""
        asked = None
        with selectors.DefaultSelector() as selector:
            for stream in self.streams:
                selector.register(stream.file, selectors.EVENT_READ, stream)
            while any(stream.end is None for stream in self.streams):
                try:
                    for key, _ in selector.select(None if asked is None else 0.1):
                        alive = key.data.read()
                        for event in key.data.events():
                            hear(*event)
                        if not alive and key.data.end is None:
                            raise EOFError
                    if asked is not None and time.monotonic() > asked + INTERRUPT_GRACE:
                        os.kill(self.running, signal.SIGKILL)
                        asked = float("inf")
                except KeyboardInterrupt:
                    os.kill(self.running, signal.SIGINT if asked is None else signal.SIGKILL)
                    asked = time.monotonic()
        return asked is not None

    def in_cell(self, text, number):
        """Messages of the compiler with places in the cell instead of files of this session."""
        text = re.sub(r"(?m)^In file included from (<<< inputs >>>|input_line_\d+):\d+:\n", "", text)
        text = text.replace("error: Parsing failed.\n", "")
        place = re.escape(self.folder.name) + rf"/cell-{self.count}-\d+"
        text = re.sub(place + r":(\d+):(\d+):", rf"cell {number}, line \1, column \2:", text)
        text = re.sub(place, f"cell {number}", text)
        return re.sub(re.escape(self.folder.name) + r"/cell-(\d+)-\d+", "an earlier cell", text)
