# SPDX-License-Identifier: MIT
"""pairs.py ROOT: whatever the program can write, and every kind of scene, has its row in tests/pairs/pairs.py, so that a test tries each
output for each kind: files that report/ and apps/ name, formats of controllers and of drawings, commands, types of motion, of segments
and of cams, followers."""

import pathlib
import re
import sys

import source_tree

FILE = re.compile(r'"([a-z_]+\.(?:csv|svg|json|html|md|dxf|pdf|step|stl|nc|obj|st|scl|txt|toml))"')
# Where else a row is demanded: file, a pattern of what is said there, and what it is.
WORDS = (
    ("shop/plc/plc_formats.cpp", r'\.key = "(\w+)"', "controller"),
    ("apps/first_commands.cpp", r'program\.add_subcommand\(\s*"(\w+)"', "command"),
    ("apps/more_commands.cpp", r'program\.add_subcommand\(\s*"(\w+)"', "command"),
    ("apps/export_options.cpp", r'program\.add_subcommand\(\s*"(\w+)"', "command"),
    ("scene/keys/motion_rows.cpp", r'"type", text, plain, any, \{([^}]*)\}', "type of motion"),
    ("scene/keys/motion_rows.cpp", r'"kind", text, plain, any, \{([^}]*)\}', "kind of segment"),
    ("profiles/kinds/kind_rows.hpp", r"\b(\w+)_kind\(\)", "type of cam"),
    ("scene/follower.hpp", r'\{FollowerType::\w+, ("\w+")', "follower"),
)


def table_of(root):
    """The names that OUTPUTS and KINDS have; None: there is no table."""
    path = pathlib.Path(root) / "tests/pairs/pairs.py"
    if not path.exists():
        return None
    table = {}
    exec(compile(path.read_text(encoding="utf-8"), str(path), "exec"), table)  # pylint: disable=exec-used
    names = set(table["OUTPUTS"]) | set(table["ELSEWHERE"])
    for command, words, files in table["OUTPUTS"].values():
        names |= {command, *words, *files}
    for stands_for, _, _ in table["KINDS"].values():
        names |= set(stands_for)
    return names


def main(root):
    names = table_of(root)
    faults, seen = [], 0
    if names is None:
        source_tree.report("pairs", [], 0)
    for path in source_tree.code(root):
        if path.parts[0] in ("report", "shop", "apps"):
            seen += 1
            code = re.sub(r"//[^\n]*", "", (pathlib.Path(root) / path).read_text(encoding="utf-8"))
            faults += [f"{path}: the file {name} has no row in tests/pairs/pairs.py" for name in sorted(set(FILE.findall(code)) - names)]
    for file, pattern, what in WORDS:
        path = pathlib.Path(root) / file
        if not path.exists():
            continue
        words = re.findall(r"\w+", " ".join(re.findall(pattern, path.read_text(encoding="utf-8"))))
        faults += [f"{file}: the {what} {word} has no row in tests/pairs/pairs.py" for word in words if word not in names]
        if not words:
            faults.append(f"{file}: names no {what}; WORDS of tests/lint/pairs.py says where they are named")
    source_tree.report("pairs", sorted(set(faults)), seen)


main(sys.argv[1])
