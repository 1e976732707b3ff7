# SPDX-License-Identifier: MIT
"""Commands that are not run, looked up: the program, the command and every option must exist."""

import functools
import json
import re
import shlex
import shutil
import subprocess

PROGRAMS = {"camopt"}  # as every page calls it; README says how a shell finds it


def simple_commands(text):
    """The commands of a block without comments, each as words."""
    text = text.replace("\\\n", " ")
    for line in text.splitlines():
        words = shlex.split(line, comments=True)
        command = []
        for word in words + ["&&"]:
            if word in ("&&", "||", "|", ";"):
                if command:
                    yield command
                command = []
            else:
                command.append(word)


@functools.lru_cache(maxsize=None)
def help_of(program, words):
    run = subprocess.run([program, *words, "--help"], capture_output=True, text=True, timeout=60, check=True)
    return run.stdout


def names_in(help_text, heading):
    found = re.search(rf"^{heading}:\n((?:  .*\n)*)", help_text, re.M)
    return set(re.findall(r"^  (?:-\w,)?([\w-]+)", found.group(1), re.M)) if found else set()


def faults_of_camopt(program, words):
    chosen = ()
    if not words:
        yield "camopt without a command"
    for number, word in enumerate(words):
        text = help_of(program, chosen)
        if word.startswith("--"):
            if word.split("=")[0] not in names_in(text, "Options"):
                yield f"camopt {' '.join(chosen)} has no option {word}"
        elif number == len(chosen) and word in names_in(text, "Subcommands"):
            chosen += (word,)
        elif not chosen:
            yield f"camopt has no command {word}"
            return


def faults_of_benchmark(root, words):
    name = words[0].rsplit("/", 1)[1]
    source = next((root / "benchmarks").rglob(f"{name}.cpp"), None)
    if not source:
        yield f"there is no benchmark {name}"
        return
    for word in words[1:]:
        if word.startswith("--") and word not in source.read_text():
            yield f"{name} knows no {word}"


def faults_of_script(root, words):
    script = root / words[0]
    if not script.exists():
        yield f"there is no {words[0]}"
        return
    text = script.read_text()
    # A script may hand its options on to a program of the tree.
    sources = [text] + [path.read_text() for path in (root / "tests" / script.name).rglob("*.*pp")]
    for word in words[1:]:
        if word.startswith("--") and not any(word in source for source in sources):
            yield f"{words[0]} knows no {word}"


def faults_of_presets(root, words):
    presets = json.loads((root / "CMakePresets.json").read_text())
    kind = {"ctest": "testPresets"}.get(words[0], "buildPresets" if "--build" in words else "configurePresets")
    names = {preset["name"] for preset in presets[kind]}
    for option, value in zip(words, words[1:]):
        if option == "--preset" and value not in names:
            yield f"{words[0]} has no preset {value}"


def faults_of_command(root, program, words):
    name = words[0]
    if name.endswith("/camopt"):
        yield f"{name}: call it camopt, as every page does"
    elif name in PROGRAMS:
        yield from faults_of_camopt(program, words[1:])
    elif name.startswith("scripts/"):
        yield from faults_of_script(root, words)
    elif name.startswith("build/release/benchmarks/"):
        yield from faults_of_benchmark(root, words)
    elif name in ("cmake", "ctest"):
        yield from faults_of_presets(root, words)
    elif name == "mpirun" and "camopt" in words:
        yield from faults_of_camopt(program, words[words.index("camopt") + 1:])
    elif not shutil.which(name) and name not in ("cd", "export", "source", "sbatch"):  # clusters have that one
        yield f"there is no program '{name}'"


def faults_of(root, program, text):
    for words in simple_commands(text):
        yield from faults_of_command(root, program, words)
