# SPDX-License-Identifier: MIT
"""view_rules.py ROOT: report/ and shop/ show what was sampled once, in units that were converted once. No file of it evaluates a
cam (CamPoints of studies/delivered/driven_mechanism.hpp does, and remembers) or divides by a unit (report/view/shown_units.hpp
does), but for WITHOUT_VIEW."""

import pathlib
import re
import sys

import source_tree

# report/view converts. NC programs and surfaces know no scene: their formats demand mm and degrees; a page of PDF counts in points.
WITHOUT_VIEW = ("report/view/", "report/surface/", "shop/nc/", "shop/step/", "shop/sheet/pdf/")
EVALUATION = re.compile(r"formulas(?:\(\))?(?:->|\.)point\(|\b(?:mechanism_point|mechanism_profile|sampled_profile)\(")
CONVERSION = re.compile(r"/ (?:units::)?(?:degree|millimetre|inch|megapascal|revolution_per_minute)\b")


def faults_of(path, text):
    code = re.sub(r"//[^\n]*", "", text)
    for what, words in ((EVALUATION, "evaluates the cam: use CamPoints::at of View::delivered.cam"),
                        (CONVERSION, "converts a unit: use ShownUnit::of (report/view/shown_units.hpp)")):
        for match in what.finditer(code):
            yield f"{path}:{code.count(chr(10), 0, match.start()) + 1}: {words}"


def main(root):
    paths = [path for path in source_tree.code(root)
             if path.parts[0] in ("report", "shop") and not path.as_posix().startswith(WITHOUT_VIEW)]
    faults = [fault for path in paths for fault in faults_of(path, (pathlib.Path(root) / path).read_text())]
    source_tree.report("view_rules", faults, len(paths))


main(sys.argv[1])
