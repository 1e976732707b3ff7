# SPDX-License-Identifier: MIT
"""versions.py ROOT: every place that names camopt's version names that of CMakeLists.txt, `project(camopt VERSION …)`.

Files by their name (`camopt-1.2.3.html`, `camopt_1.2.3_amd64.deb`), `find_package(camopt 1.2`, sonames, `1.2.x`, CITATION.cff
and the newest release of CHANGELOG.md, with its date. benchmarks/RESULTS.md may be older than the project: that is printed, but
is no fault."""

import pathlib
import re
import sys

import source_tree

# A version as (major.minor) or (major.minor.patch), each with the text around it.
SAID = re.compile(r"find_package\(camopt (\d+\.\d+(?:\.\d+)?)|libcamopt(?:_c)?\.so\.(\d+\.\d+(?:\.\d+)?)|\b(\d+\.\d+)\.x\b"
                  r"|compiles with (\d+\.\d+\.\d+)|\bcamopt[-_ ](\d+\.\d+\.\d+)|implementation_version = \"(\d+\.\d+\.\d+)\"")
SUFFIXES = {".md", ".cff", ".txt", ".cmake", ".in", ".py", ".sh", ".toml", ".cpp", ".hpp", ".h", ".c", ".js", ".html", ".nsi",
            ".sbatch", ""}
# Versions of other times on purpose: the history, measurements, and tests of a version that does not fit.
OF_OTHER_TIMES = ("CHANGELOG.md", "benchmarks/RESULTS.md", "benchmarks/results/", "tests/lint/", "tests/report/",
                  "tests/package/incompatible/")
RELEASE = re.compile(r"^## \[?(\d+\.\d+\.\d+)\]? – (.*)$", re.M)


def version_of(root):
    path = root / "CMakeLists.txt"
    found = re.search(r"project\(camopt VERSION (\d+\.\d+\.\d+)", path.read_text()) if path.exists() else None
    return found[1] if found else ""


def faults_of_words(root, path, version):
    for number, line in enumerate((root / path).read_text(errors="replace").splitlines(), 1):
        for match in SAID.finditer(line):
            said = next(filter(None, match.groups()))
            if said != version and not version.startswith(said + "."):
                yield f"{path}:{number}: '{match[0]}': CMakeLists.txt has version {version}"


def release_of(root):
    """Version and date of the newest release in CHANGELOG.md."""
    found = RELEASE.search((root / "CHANGELOG.md").read_text()) if (root / "CHANGELOG.md").exists() else None
    return (found[1], found[2]) if found else ("", "")


def faults_of_places(root, version):
    """Places that must have a version, so that none is lost."""
    released, date = release_of(root)
    if released != version:
        yield f"CHANGELOG.md: its newest release is '{released}'; CMakeLists.txt has version {version}"
    if not re.fullmatch(r"\d{4}-\d\d-\d\d", date):
        yield f"CHANGELOG.md: the release {released} has the date '{date}'; allowed: YYYY-MM-DD"
    citation = (root / "CITATION.cff").read_text()
    for key, wanted in (("version", version), ("date-released", date)):
        found = re.search(rf"^{key}: *(\S+)$", citation, re.M)
        if not found or found[1] != wanted:
            yield f"CITATION.cff: {key} is '{found[1] if found else ''}'; CMakeLists.txt and CHANGELOG.md have {wanted}"
    for name, words in (("bindings/python/pyproject.toml", 'dynamic = ["version"]'),
                        ("bindings/python/setup.py", "CMakeLists.txt")):
        if (root / name).exists() and words not in (root / name).read_text():
            yield f"{name}: no '{words}': the Python package takes its version from CMakeLists.txt"


def print_age_of_results(root, version):
    path = root / "benchmarks/RESULTS.md"
    measured = set(re.findall(r"^ *camopt: (\S+)$", path.read_text(), re.M)) if path.exists() else {version}
    if measured != {version}:
        print(f"versions: note: benchmarks/RESULTS.md is of camopt {', '.join(sorted(measured))}, not {version}; scripts/benchmark "
              "on an idle machine writes it again")


def main():
    root = pathlib.Path(sys.argv[1])
    version = version_of(root)
    if not version:
        source_tree.report("versions", [], 0)
    paths = [path for path in source_tree.files(root)
             if path.suffix in SUFFIXES and not path.as_posix().startswith(OF_OTHER_TIMES)]
    faults = [*faults_of_places(root, version), *(fault for path in paths for fault in faults_of_words(root, path, version))]
    print_age_of_results(root, version)
    source_tree.report("versions", faults, len(paths))


main()
