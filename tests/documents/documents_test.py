# SPDX-License-Identifier: MIT
"""documents_test.py ROOT --program CAMOPT --prefix PREFIX --scratch FOLDER …: every block of README.md, CONTRIBUTING.md and
docs/ is run, compiled, read or looked up. A block that nobody claims is a fault.

toml    camopt check reads it           cpp, c   compiled against what is installed in PREFIX; with a main also run
sh      run in a scratch copy           cmake    configured with the last whole program above it; the first is built and run
python  run                             usage   options looked up              text, gcode: what programs print; no commands
Commands and code stand in fences: an indented block with one is a fault too.
"""

import argparse
import collections
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import blocks
import commands

PRINTED = {"text", "gcode"}


# The first line of a function that begins at the margin: "void limit(camopt::Scene& scene) {".
FUNCTION = re.compile(r"^(?!if|for|while|switch)[A-Za-z_:]+ [a-z_]+\(.*\) \{$")


class Documents:
    def __init__(self, options):
        self.options = options
        self.root = options.root.resolve()
        self.scratch = options.scratch.resolve()
        self.part = options.part
        self.program = options.program.resolve()
        self.counts = collections.Counter()
        self.remarks = []
        path = os.pathsep.join([str(self.program.parent), os.environ["PATH"]])
        found = f"{self.options.prefix}/{self.options.libdir}/pkgconfig"
        self.surroundings = dict(os.environ, PATH=path, PKG_CONFIG_PATH=found, LC_ALL="C.UTF-8")
        # What a clone has compiled another one, or the next run, finds in the compiler cache.
        self.launcher = ["ccache"] if shutil.which("ccache") else []
        for name, value in (("CCACHE_BASEDIR", str(self.root)), ("CCACHE_NOHASHDIR", "1")):
            self.surroundings.setdefault(name, value)
        # scripts/packages.txt has no make, which is CMake's default.
        self.surroundings.setdefault("CMAKE_GENERATOR", "Ninja")
        self.whole_program = None

    # The scratch copy: what commands of the pages name, and a place for what they write.

    def lay_out(self):
        shutil.rmtree(self.scratch, ignore_errors=True)
        (self.scratch / "build/release").mkdir(parents=True)
        (self.scratch / "build/release/apps").symlink_to(self.program.parent)
        for folder in ("scenes", "docs/posts", "apps/completion"):
            shutil.copytree(self.root / folder, self.scratch / folder)

    def run(self, words, folder=None, seconds=120, path=None):
        """None, or the words of the fault."""
        try:
            surroundings = dict(self.surroundings, PATH=path or self.surroundings["PATH"])
            done = subprocess.run(words, cwd=folder or self.scratch, env=surroundings, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=seconds)
        except subprocess.TimeoutExpired:
            return f"not done after {seconds} s"
        return f"exit code {done.returncode}: {done.stdout[-1500:]}" if done.returncode else None

    def file_for(self, block, name):
        folder = self.scratch / "blocks" / block.place.replace("/", "_").replace(":", "_")
        folder.mkdir(parents=True, exist_ok=True)
        return folder / name

    # One function a language: each says what was done, and the fault or None.

    def toml(self, block):
        path = self.file_for(block, "scene.toml")
        path.write_text(block.notes.get("with", "") + "\n" + block.text, encoding="utf-8")
        if block.saved_as:
            shutil.copy(path, self.scratch / block.saved_as)
        return "scenes read by camopt check", self.run([self.program, "check", path])

    def sh(self, block):
        reason = block.notes.get("not run")
        if reason:
            self.remarks.append(f"{block.place}: commands looked up, NOT RUN: {reason}")
            return "blocks of commands looked up", "; ".join(commands.faults_of(self.root, self.program, block.text)) or None
        for words in commands.simple_commands(block.text):
            if words[0].startswith("scripts/") or words[0] in ("cmake", "ctest"):
                return "", f"{words[0]} needs the comment <!-- not run: REASON -->"
            if words[0].endswith("/camopt"):
                return "", next(commands.faults_of_command(self.root, self.program, words))
        text = block.text
        # A block that says how the program is found must find it without help.
        path = None if "export PATH=" not in text else os.environ["PATH"]
        if "opencascade" not in self.options.has and " --step" in text:
            self.remarks.append(f"{block.place}: run WITHOUT --step: this build has no Open CASCADE")
            text = text.replace(" --step", "")
        script = f"set -euo pipefail\n{text}"
        return "blocks of commands run", self.run(["bash", "-c", script], self.scratch / block.notes.get("in", "."), path=path)

    def usage(self, block):
        """Brackets and bars are the notation, not the command."""
        text = re.sub(r"[][|…]", " ", block.text)
        return "synopses looked up", "; ".join(commands.faults_of(self.root, self.program, text)) or None

    def flags(self):
        words = ["pkg-config", "--cflags", "camopt"]
        run = subprocess.run(words, env=self.surroundings, capture_output=True, text=True, check=True)
        return run.stdout.split() + self.options.flags.split()

    def remember(self, block):
        """A whole program of a page that another part runs: blocks of CMake below build it."""
        if block.language in ("c", "cpp") and "int main(" in block.text:
            self.whole_program = block

    def cpp(self, block):
        if "int main(" in block.text:
            self.whole_program = block
            return "C++ programs, built with the next block of CMake", None
        given = block.notes.get("with", "").splitlines()
        lines = block.text.splitlines()
        top = [line for line in given + lines if line.startswith(("#include", "using namespace"))]
        rest = [line for line in given + [f'#line {block.line + 1} "{block.page}"'] + lines if line not in top]
        # Statements stand in a function, whole functions by themselves.
        around = ([], []) if any(FUNCTION.match(line) for line in lines) else (["void block() {"], ["}"])
        source = self.file_for(block, "part.cpp")
        source.write_text("\n".join(top + around[0] + rest + around[1]) + "\n", encoding="utf-8")
        return "parts of C++ compiled", self.run([*self.launcher, self.options.compiler, "-std=c++20", "-O0", "-c", *self.flags(),
                                                  source, "-o", source.with_suffix(".o")])

    def c(self, block):
        text = block.text
        if "int main(" in text:
            self.whole_program = block
            return self.c_program(block)
        lines = block.notes.get("with", "").splitlines() + text.splitlines()
        top = [line for line in lines if line.startswith("#include")]
        text = "\n".join(top + ["void block(void) {"] + [line for line in lines if line not in top] + ["}\n"])
        source = self.file_for(block, "part.c")
        source.write_text(text, encoding="utf-8")
        return "parts of C compiled", self.run(["cc", "-std=c99", "-fsyntax-only", *self.flags(), source])

    def c_program(self, block):
        source = self.file_for(block, "program.c")
        source.write_text(block.text, encoding="utf-8")
        build = "cc -std=c99 program.c -o program $(pkg-config --cflags --libs camopt_c) && ./program"
        self.surroundings["LD_LIBRARY_PATH"] = f"{self.options.prefix}/{self.options.libdir}"
        return "C programs built and run", self.run(["bash", "-c", build], source.parent)

    def cmake(self, block):
        """Configured with the last whole program above it; the first of C++ is built and run."""
        if not self.whole_program:
            return "", "no page before it has a whole C++ program"
        language, name = ("C", "main.c") if self.whole_program.language == "c" else ("CXX", "main.cpp")
        project = self.file_for(block, "CMakeLists.txt")
        project.write_text(f"cmake_minimum_required(VERSION 3.25)\nproject(documents LANGUAGES {language})\n"
                           f"add_executable(program {name})\n" + block.text, encoding="utf-8")
        project.with_name(name).write_text(self.whole_program.text, encoding="utf-8")
        if "add_subdirectory(camopt" in block.text and not project.with_name("camopt").exists():
            project.with_name("camopt").symlink_to(self.root)
        build = project.with_name("build")
        fault = self.run(["cmake", "-S", project.parent, "-B", build, f"-DCMAKE_PREFIX_PATH={self.options.prefix}",
                          f"-DCMAKE_CXX_COMPILER={self.options.compiler}", f"-DCMAKE_CXX_FLAGS={self.options.flags}",
                          f"-DCMAKE_CXX_COMPILER_LAUNCHER={';'.join(self.launcher)}"])
        if fault or language == "C" or self.counts["C++ programs built and run"]:
            return "blocks of CMake configured", fault
        fault = self.run(["cmake", "--build", build]) or self.run([build / "program"])
        self.counts["C++ programs built and run"] += 0 if fault else 1
        return "blocks of CMake configured", fault

    def python(self, block):
        source = self.file_for(block, "block.py")
        text = block.notes.get("with", "") + "\n" + block.text
        source.write_text(text, encoding="utf-8")
        folder = self.scratch / block.notes.get("in", ".")
        if "import camopt" in text:
            self.remarks.append(f"{block.place}: only parsed: the test python.docs runs it")
            return "blocks of Python parsed", self.run([self.options.python, "-m", "py_compile", source])
        return "blocks of Python run", self.run([self.options.python, "-B", source], folder)

    def fault_of(self, block):
        if block.language in PRINTED:
            self.counts["blocks that programs print"] += 1
            first = block.text.split(maxsplit=1)[:1]
            return "a command; its fence must be 'sh'" if first and first[0] in commands.PROGRAMS else None
        check = {"toml": self.toml, "sh": self.sh, "usage": self.usage, "cpp": self.cpp, "c": self.c, "cmake": self.cmake,
                 "python": self.python}.get(block.language)
        if not check:
            known = "toml, sh, usage, cpp, c, cmake, python; text, gcode for what is printed"
            return f"nobody claims a block of '{block.language}'; allowed: {known}"
        what, fault = check(block)
        self.counts[what] += 1
        return fault


def read_options():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--prefix", type=pathlib.Path, required=True)
    parser.add_argument("--libdir", default="lib")
    parser.add_argument("--scratch", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--flags", default="")
    parser.add_argument("--has", action="append", default=[], help="an optional library of this build: opencascade")
    parser.add_argument("--python", default=sys.executable)
    parser.add_argument("--part", default="1/1", help="K/N: of the pages K, K + N, …")
    return parser.parse_args()


def main():
    documents = Documents(read_options())
    documents.lay_out()
    slowest = (0.0, "")
    indented = blocks.indented_commands(documents.root)
    faults = len(indented)
    for place in indented:
        print(f"{place}: a command in an indented block; fence it as 'sh', or as 'usage'")
    part, parts = (int(number) for number in documents.part.split("/"))
    own_pages = blocks.pages_of(documents.root)[part - 1::parts]
    found = blocks.all_blocks(documents.root)
    for block in found:
        if block.page not in own_pages:
            documents.remember(block)
            continue
        begin = time.monotonic()
        fault = documents.fault_of(block)
        slowest = max(slowest, (time.monotonic() - begin, block.place))
        if fault:
            faults += 1
            print(f"{block.place}: {fault}")
    print("\n".join(documents.remarks))
    for what, count in sorted(documents.counts.items()):
        print(f"{count:4} {what}")
    print(f"documents: {len([block for block in found if block.page in own_pages])} blocks, {faults} faults; the slowest took {slowest[0]:.1f} s: {slowest[1]}")
    sys.exit(1 if faults or not found else 0)


main()
