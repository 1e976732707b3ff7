# SPDX-License-Identifier: MIT
"""include_rules.py ROOT: each folder includes, and links, only the folders that the design allows it, and no two folders, at
any level, include each other in a circle."""

import pathlib
import re
import sys

import source_tree

QUOTED = re.compile(r'^\s*#\s*include\s*"([^"]+)"')
LINKED = re.compile(r"\bcamopt::([a-z_]+)\b")
# A leaf's target is named after its path, camopt::profiles_inverse; so are parts of a module (camopt::studies_spatial).
TARGETS = {module.replace("/", "_"): module for module in source_tree.MAY_INCLUDE}
TARGETS |= {f"studies_{part}": "studies" for part in ("inverse", "restored", "solve", "spatial")}
TARGETS |= {"input_known": "input/loading", "report_result": "report", "report_page_plane": "report/page"}
TARGETS["shop_pdf"] = "shop/sheet"


def faults_of_code(root, path):
    folder = source_tree.module_of(path)
    if folder not in source_tree.MAY_INCLUDE:
        yield f"{path}: folder {folder}/ has no line in tests/lint/source_tree.py"
        return
    allowed = source_tree.MAY_INCLUDE[folder] | {folder}
    lines = (root / path).read_text().splitlines()
    own = path.with_suffix(".hpp")
    if path.suffix == ".cpp" and folder in source_tree.EVERY_MODULE and (root / own).is_file():
        first = next((line for line in lines if line.startswith("#include")), "")
        if first != f'#include "{own.as_posix()}"':
            yield f"{path}: its own header must be the first that it includes, which shows that the header stands by itself"
    for number, line in enumerate(lines, 1):
        match = QUOTED.match(line)
        if not match:
            continue
        included = match.group(1)
        target = source_tree.module_of(included)
        if folder not in source_tree.EVERY_MODULE and any(
                (base / included).is_file() for base in (root / folder, (root / path).parent)):
            continue  # a helper of the tests or benchmarks themselves
        if "/" not in included or ".." in included:
            yield f"{path}:{number}: \"{included}\" must be named from the project's root"
        elif not (root / included).is_file():
            yield f"{path}:{number}: \"{included}\" does not exist"
        elif target not in allowed:
            yield f"{path}:{number}: {folder}/ must not include {target}/"


def faults_of_links(root, path):
    folder = source_tree.module_of(path)
    if folder not in source_tree.EVERY_MODULE:
        return
    allowed = source_tree.MAY_INCLUDE[folder] | {folder}
    for number, line in enumerate((root / path).read_text().splitlines(), 1):
        for target in LINKED.findall(line.split("#")[0]):
            if TARGETS.get(target, target) not in allowed:
                yield f"{path}:{number}: {folder}/ must not link camopt::{target}"


def cycles(root, code):
    """Folders, at every level, that include each other in a circle; with one include of each step."""
    includes = {}
    for path in code:
        folder = path.parent.as_posix()
        if source_tree.module_of(path) not in source_tree.EVERY_MODULE:
            continue
        for line in (root / path).read_text().splitlines():
            match = QUOTED.match(line)
            target = pathlib.PurePosixPath(match.group(1)).parent.as_posix() if match else folder
            if target != folder and (root / match.group(1)).is_file():
                includes.setdefault(folder, {}).setdefault(target, path)
    done, found = set(), []

    def follow(folder, way):
        if folder in way:
            ring = way[way.index(folder):] + [folder]
            found.append("folders include each other in a circle: " + ", ".join(
                f"{user} -> {used} ({includes[user][used]})" for user, used in zip(ring, ring[1:])))
        elif folder not in done:
            for target in sorted(includes.get(folder, {})):
                follow(target, way + [folder])
            done.add(folder)

    for folder in sorted(includes):
        follow(folder, [])
    return found


def main():
    root = pathlib.Path(sys.argv[1])
    # Consumers of the installed package stand outside the tree.
    code = [path for path in source_tree.code(root) if path.parts[:2] != ("tests", "package")]
    lists = [path for path in source_tree.files(root) if path.name == "CMakeLists.txt"]
    faults = [fault for path in code for fault in faults_of_code(root, path)]
    faults += cycles(root, code)
    faults += [fault for path in lists for fault in faults_of_links(root, path)]
    source_tree.report("include_rules", faults, len(code))


main()
