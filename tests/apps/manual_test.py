# SPDX-License-Identifier: MIT
"""manual_test.py PROGRAM PAGE: every command and option of --help stands in the manual page, and every key of a scene;
the page is rendered without a complaint where mandoc or man is on this machine."""

import json
import re
import shutil
import subprocess
import sys

OPTION = re.compile(r"^  (-[^\s]+)", re.M)


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout


def listed(help_text, heading):
    """The lines below a heading of the help, as far as they are indented."""
    found = re.search(rf"^{heading}:\n((?:  .*\n)*)", help_text, re.M)
    return found.group(1) if found else ""


def commands_of(program, words=()):
    """Every command with its options: (words, options)."""
    help_text = output_of(program, *words, "--help")
    options = [name for row in OPTION.findall(listed(help_text, "Options")) for name in row.split(",")]
    yield words, options
    for name in re.findall(r"^  (\S+)", listed(help_text, "Subcommands"), re.M):
        yield from commands_of(program, words + (name,))


def section_of(page, title):
    """The text of a section or of the part of a command, up to the next heading."""
    start = page.find(f'.SS "{title}"\n') if title != "OPTIONS" else page.find(".SH OPTIONS\n")
    if start < 0:
        return None
    end = re.search(r"^\.S[SH] ", page[start + 1:], re.M)
    return page[start:start + 1 + end.start()] if end else page[start:]


def faults_of(program, page):
    count = 0
    for words, options in commands_of(program):
        title = " ".join(("camopt",) + words) if words else "OPTIONS"
        text = section_of(page, title)
        if text is None:
            yield f"the manual has no part '{title}'"
            continue
        tags = re.findall(r"^\.TP\n\.BI? (.*)$", text, re.M)
        named = {name for tag in tags for name in re.findall(r"--?[a-z][a-z-]*", tag)}
        count += len(options)
        yield from (f"'{title}' of the manual lacks {name}" for name in options if name not in named)
    keys = json.loads(output_of(program, "list", "keys", "--json"))
    text = page[page.find(".SH KEYS OF A SCENE"):]
    for row in keys:
        yield from (f"the manual lacks the key {key['key']}" for key in row["keys"]
                    if not re.search(rf"\b{re.escape(key['key'])}\b", text))
    if count < 40 or len(keys) < 60:
        yield f"only {count} options and {len(keys)} keys were found: the help is not read as it should be"


def complaints(path):
    if shutil.which("mandoc"):
        # Without a date on purpose: the same sources give the same page.
        run = subprocess.run(["mandoc", "-Tlint", "-Wwarning", path], capture_output=True, text=True, timeout=60)
        return [line for line in run.stdout.splitlines() if ("WARNING" in line or "ERROR" in line) and "missing date" not in line]
    if shutil.which("groff"):
        run = subprocess.run(["groff", "-man", "-ww", "-K", "utf8", "-z", path], capture_output=True, text=True, timeout=60)
        return run.stderr.splitlines()
    print("manual_test: neither mandoc nor groff is on this machine; the page is not rendered")
    return []


def main():
    program, path = sys.argv[1:]
    page = open(path, encoding="utf-8").read().replace("\\-", "-")
    faults = list(faults_of(program, page)) + complaints(path)
    print("\n".join(faults + [f"manual_test: {len(faults)} faults"]))
    sys.exit(1 if faults else 0)


main()
