# SPDX-License-Identifier: MIT
"""include_rules.py ROOT: each folder includes, and links, only the folders that the design allows it, and neither folders, at
any level, nor files include each other in a circle; a header and the source of its name are one file."""

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
PRODUCTION = source_tree.EVERY_MODULE | {"apps", "bindings"}


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


def included_files(root, path):
    for line in (root / path).read_text().splitlines():
        match = QUOTED.match(line)
        if match and (root / match.group(1)).is_file():
            yield pathlib.PurePosixPath(match.group(1))


def rings(includes):
    """One circle through each step back; includes: of each place the places that it includes."""
    done, found = set(), []

    def follow(place, way):
        if place in way:
            found.append(way[way.index(place):] + [place])
        elif place not in done:
            for target in sorted(includes.get(place, {})):
                follow(target, way + [place])
            done.add(place)

    for place in sorted(includes):
        follow(place, [])
    return found


def cycles(root, code):
    """Folders, at every level, that include each other in a circle, and files, of which a header and the source of its name
    are one; with one include of each step."""
    found = []
    for what, place_of, modules in (("folders", lambda path: path.parent.as_posix(), source_tree.EVERY_MODULE),
                                    ("files", lambda path: path.with_suffix("").as_posix(), PRODUCTION)):
        includes = {}
        for path in code:
            if source_tree.module_of(path) not in modules:
                continue
            place = place_of(pathlib.PurePosixPath(path))
            for included in included_files(root, path):
                if place_of(included) != place:
                    includes.setdefault(place, {}).setdefault(place_of(included), path)
        for ring in rings(includes):
            found.append(f"{what} include each other in a circle: " + ", ".join(
                f"{user} -> {used} ({includes[user][used]})" for user, used in zip(ring, ring[1:])))
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
