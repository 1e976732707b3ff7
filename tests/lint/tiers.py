# SPDX-License-Identifier: MIT
"""tiers.py ROOT BUILD: every test of a build has one tier, no case of its last run (BUILD/tests.xml, written by scripts/test)
exceeds that tier, nor all of them the tier's budget, and every skip in it is accepted by name (tests/skips.txt).

A case above twice the seconds of its tier (processors of CI differ that much) runs once more, alone; still above, it is named.
Exit status: 1 where a test has no tier or a skip is not accepted; 78 where tests are slow or a pattern of tests/tiers.txt has no
case (its test was renamed or deleted) and nothing else is wrong; 0."""

import argparse
import collections
import fnmatch
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import skips

# Seconds of one case, and of a tier as a whole on two cores (docs/verification.md).
LIMIT = {"unit": 0.5, "solve": 3.0, "product": 60.0, "python": 60.0}
BUDGET = {"unit": 60.0, "solve": 150.0, "product": 180.0}
TIERS = ("unit", "solve", "product", "python", "nightly")
OTHER_LABELS = ("lint", "fuzz")
NAMED = 2.0  # times the limit
FOUND = 78  # exit status: findings in tests that work


def labels_of_build(build):
    """{test: labels}."""
    output = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=True).stdout
    return {test["name"]: [label for one in test.get("properties", []) if one["name"] == "LABELS" for label in one["value"]]
            for test in json.loads(output)["tests"] if not test["name"].endswith("_NOT_BUILT")}


def times_of_run(file):
    """{test: seconds} of what ran."""
    return {case.get("name"): float(case.get("time"))
            for case in xml.etree.ElementTree.parse(file).iter("testcase") if case.get("status") in ("run", "fail")}


def seconds_alone(build, name, most):
    """Of one more run without company, ended after `most` seconds; what a fixture prepared is still there."""
    with tempfile.NamedTemporaryFile(suffix=".xml") as file:
        pattern = "^" + re.sub(r"([][.^$*+?()\\|])", r"\\\1", name) + "$"
        subprocess.run(["ctest", "--test-dir", build, "-R", pattern, "-FA", ".*", "--timeout", f"{most:g}",
                        "--output-junit", file.name],
                       capture_output=True, check=False)
        return times_of_run(file.name).get(name, 0.0)


def untiered(labels):
    for name, own in labels.items():
        tiers = [label for label in own if label in TIERS]
        if len(tiers) != 1 and not any(label in OTHER_LABELS for label in own):
            yield f"{name}: found {len(tiers)} tiers; one of {', '.join(TIERS)} is needed (camopt_label)"


def stale_patterns(root, labels):
    for line in (root / "tests/tiers.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            tier, pattern = line.split()
            if not any(tier in own and fnmatch.fnmatchcase(name, pattern) for name, own in labels.items()):
                yield f"tests/tiers.txt: '{pattern}' is no case of the tier {tier}"


def too_slow(build, labels, times):
    """Words of every case that takes too long, alone too, and of every tier above its budget."""
    sums = collections.Counter()
    for name, seconds in times.items():
        for tier in labels.get(name, []):
            sums[tier] += seconds
            limit = LIMIT.get(tier)
            if limit is None or seconds <= NAMED * limit:
                continue
            again = seconds_alone(build, name, 4.0 * NAMED * limit)
            if again > NAMED * limit:
                yield (f"{name}: {seconds:.2f} s, alone {again:.2f} s; a case of the tier {tier} may take {limit} s. "
                       "Make it quicker, or name a longer tier in tests/tiers.txt")
    for tier, total in sums.items():
        on_two_cores = total / 2.0
        print(f"tiers: {tier} {total:.0f} s of tests, {on_two_cores:.0f} s on two cores")
        if on_two_cores > BUDGET.get(tier, on_two_cores):
            yield f"the tier {tier}: {on_two_cores:.0f} s on two cores; its budget is {BUDGET[tier]:.0f} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    arguments = parser.parse_args()
    labels, times = labels_of_build(arguments.build), times_of_run(arguments.build / "tests.xml")
    if not times:
        sys.exit("tiers: the run holds no test")
    faults = [*untiered(labels), *skips.faults(arguments.root, arguments.build / "tests.xml")]
    findings = [*stale_patterns(arguments.root, labels), *too_slow(arguments.build, labels, times)]
    print("\n".join(faults + [f"finding: {words}" for words in findings]))
    print(f"tiers: {len(faults)} faults and {len(findings)} findings in {len(times)} tests")
    return 1 if faults else FOUND if findings else 0


if __name__ == "__main__":
    sys.exit(main())
