# SPDX-License-Identifier: MIT
"""platform_seam.py ROOT: what differs between operating systems stands in core/platform/ alone, and in the toolchains of
cmake/platforms/: nowhere else a macro of a system, a header of one, or a function that only one has. Exempt: the studio's HTTP server, which exists only where its
library does; the notebooks' kernel; tests and benchmarks, which run on Linux."""

import pathlib
import re
import sys

import source_tree

SEAM = ("core/platform/", "cmake/platforms/")
EXEMPT = ("apps/studio/loopback_server.cpp", "apps/studio/request_room.cpp", "notebooks_cpp/", "tests/", "benchmarks/")
MACRO = re.compile(r"^\s*#\s*(?:if|ifdef|ifndef|elif)\b.*\b_*(?:WIN32|WIN64|MINGW\w*|MSC_VER|linux|unix|APPLE|wasi|wasm\w*|EMSCRIPTEN|CYGWIN)_*\b", re.M)
HEADER = re.compile(r"^\s*#\s*include\s*<(?:unistd|fcntl|io|poll|dlfcn|spawn|termios|pthread|signal|windows|shellapi|dirent|pwd|sys/\w+|netinet/\w+|arpa/\w+)\.h>"
                    r"|^\s*#\s*include\s*<csignal>", re.M)
FUNCTION = re.compile(r"\b(?:getpid|fork|mkd?s?temp|setenv|unsetenv|readlink|isatty|fsync|sigaction|localtime_r|gmtime_r|popen)\s*\(")


def faults_of(path, text):
    code = re.sub(r"//[^\n]*", "", text)
    for what, words in ((MACRO, "asks which system it is"), (HEADER, "includes a header of a system"),
                        (FUNCTION, "calls a function of a system")):
        for match in what.finditer(code):
            line = code.count("\n", 0, match.start()) + 1 + match.group(0).startswith("\n")
            yield f"{path}:{line}: {words}: only core/platform/ may"


def main(root):
    paths = [path for path in source_tree.code(root) if not path.as_posix().startswith(SEAM + EXEMPT)]
    faults = [fault for path in paths for fault in faults_of(path, (pathlib.Path(root) / path).read_text())]
    source_tree.report("platform_seam", faults, len(paths))


main(sys.argv[1])
