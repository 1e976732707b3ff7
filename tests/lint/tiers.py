# SPDX-License-Identifier: MIT
"""tiers.py ROOT BUILD: every test of a build has one tier, no case of its last run
(BUILD/tests.xml, written by scripts/test) exceeds that tier, and every skip in it is accepted by name (tests/skips.txt).

A case above twice the seconds of its tier runs once more, alone. Still above, it is named; above four times it is a fault: the
processors of CI differ by a factor of two. Exit status 1 where there is a fault."""

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
NAMED, FAULT = 2.0, 4.0  # times the limit


def plain(name):
    """A case's name without the value of its parameter, which ctest prints after it."""
    return name.split("  # GetParam", 1)[0].strip()


def labels_of_build(build):
    """{test: labels}."""
    output = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=True).stdout
    return {plain(test["name"]): [label for one in test.get("properties", []) if one["name"] == "LABELS" for label in one["value"]]
            for test in json.loads(output)["tests"] if not test["name"].endswith("_NOT_BUILT")}


def times_of_run(file):
    """{test: seconds} of what ran."""
    return {plain(case.get("name")): float(case.get("time"))
            for case in xml.etree.ElementTree.parse(file).iter("testcase") if case.get("status") in ("run", "fail")}


def seconds_alone(build, name, most):
    """Of one more run without company, ended after `most` seconds; what a fixture prepared is still there."""
    with tempfile.NamedTemporaryFile(suffix=".xml") as file:
        pattern = "^" + re.sub(r"([][.^$*+?()\\|])", r"\\\1", name) + "( |$)"
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
    """(is a fault, words) of every case that takes too long, alone too."""
    for name, seconds in times.items():
        for tier in labels.get(name, []):
            limit = LIMIT.get(tier)
            if limit is None or seconds <= NAMED * limit:
                continue
            again = seconds_alone(build, name, FAULT * limit + 1.0)
            if again > NAMED * limit:
                yield again > FAULT * limit, (f"{name}: {seconds:.2f} s, alone {again:.2f} s; a case of the tier {tier} may take {limit} s. "
                                              "Make it quicker, or name a longer tier in tests/tiers.txt")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    arguments = parser.parse_args()
    labels, times = labels_of_build(arguments.build), times_of_run(arguments.build / "tests.xml")
    if not times:
        sys.exit("tiers: the run holds no test")
    faults = [*untiered(labels), *stale_patterns(arguments.root, labels), *skips.faults(arguments.root, arguments.build / "tests.xml")]
    for is_fault, words in too_slow(arguments.build, labels, times):
        if is_fault:
            faults.append(words)
        else:
            print(f"slow: {words}")
    sums = collections.Counter()
    for name, seconds in times.items():
        for tier in labels.get(name, []):
            sums[tier] += seconds
    for tier, total in sums.items():
        print(f"tiers: {tier} {total:.0f} s of tests" + (f", {total / 2:.0f} s of {BUDGET[tier]:.0f} on two cores" if tier in BUDGET else ""))
    print("\n".join(faults + [f"tiers: {len(faults)} faults in {len(times)} tests"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
