# SPDX-License-Identifier: MIT
"""one_place.py ROOT: what one file of production C++ knows, no other spells again. RULES is the table: what the code must not
hold, what to use in its place, the folders that are read (empty: all), and the files where it is right, each with its reason."""

import pathlib
import re
import sys

import source_tree

UNIT = r"(?:mm|cm|m|um|in|mil|m?deg|crank_deg|rad|rev|s|rpm|hz|kg|lb|n|nm|lbf|m?pa|gpa|ksi)"
SUFFIX = rf"_{UNIT}(?:_(?:per_)?{UNIT}[23]?)*"
READERS = ("input/", "scene/faults/", "scene/motion/", "objectives/", "studies/", "profiles/", "dynamics/")
RULES = [
    (r"\b25\.4\b|\b0\.0254\b|\bpi / (?:180|30)\b|\b180(?:\.0)? / (?:std::numbers::)?pi\b|[*/] 60\.0\b|\b60\.0 /",
     "a factor of a unit: use unit_named (core/unit.hpp) or core/units.hpp", (),
     {"core/units.hpp": "the factors themselves",
      "core/numbers/robust_fit.cpp": "6 deg, a width in rad whose last digit decides what is an outlier"}),
    (rf'"{SUFFIX}"', "the suffix of a unit: use Spelling::suffix (core/unit.hpp)", (),
     {"core/unit.hpp": "the suffixes themselves",
      "report/valves/valves_document.cpp": "degrees of a crankshaft that is a machine's own axis, not a cam's angle doubled"}),
    (rf'".*?\b(?!run_in\b|run_out\b)[a-z]+(?:_[a-z]+)*?{SUFFIX}\b',
     "a key with its unit as text: use the row's first_key(), keys_text or fitting_keys", READERS,
     {"input/document/overrides.cpp": "an example of a setting",
      "studies/sweep/sweep_axis.cpp": "an example of an axis"}),
    (r'"[a-z_.]+\[\{\}\]', "an entry of a list by hand: use entry_key or segment_key (scene/part_names.hpp)",
     ("input/", "scene/", "objectives/", "studies/", "apps/", "bindings/", "report/machine/", "report/view/"),
     {"studies/search/free_knots.cpp": "entries of the design, which are no keys"}),
    (r'\b(\w+) \+=[^;]*?\b\1\.empty\(\) \? (?:"" : "[,;] |std::string_view)|[:?] " (?:and|or) "',
     "a list joined by hand: use listed or append_item (core/text/list_text.hpp)", (), {
         "scene/key_row.cpp": "two bounds of a range, each of which may be absent"}),
    (r'(?:"displacement"),\s*"velocity",\s*"acceleration"', "names of derivatives: use derivative_names (core/motion.hpp)", (),
     {"core/motion.hpp": "the names themselves"}),
]
LITERAL = re.compile(r'"(?:[^"\\\n]|\\.)*"')  # patterns that begin with a quote are searched in each of these
COMPILED = [(re.compile(pattern), *rest) for pattern, *rest in RULES]
FOLDERS = {"apps", "bindings", *(folder.split("/")[0] for folder in source_tree.EVERY_MODULE)}


def faults_of(name, text):
    code = re.sub(r"//[^\n]*", "", text)
    for pattern, instead, folders, right in COMPILED:
        if name in right or (folders and not name.startswith(folders)):
            continue
        if pattern.pattern.startswith('"'):
            found = [literal.start() for literal in LITERAL.finditer(code) if pattern.search(literal[0])]
        else:
            found = [match.start() for match in pattern.finditer(code)]
        yield from (f"{name}:{code.count(chr(10), 0, start) + 1}: {instead}" for start in found)


def main(root):
    paths = [path for path in source_tree.code(root) if path.parts[0] in FOLDERS and "examples" not in path.parts]
    faults = [fault for path in paths for fault in faults_of(path.as_posix(), (pathlib.Path(root) / path).read_text())]
    gone = [f"tests/lint/one_place.py: {name} does not exist" for *_, right in RULES for name in right
            if not (pathlib.Path(root) / name).is_file() and (pathlib.Path(root) / "scripts/lint").is_file()]
    source_tree.report("one_place", faults + gone, len(paths))


main(sys.argv[1])
