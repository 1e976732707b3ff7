# SPDX-License-Identifier: MIT
"""The files of a camopt tree, for the lint checks. Python's standard library only."""

import pathlib
import sys

# Which folder may include which (docs/architecture.md).
MAY_INCLUDE = {
    "core": set(),
    "scene": {"core"},
    "linear": {"core"},
    "motions": {"core"},
    "splines": {"core", "linear"},
    "profiles": {"core", "scene"},
    "dynamics": {"core", "scene"},
    "objectives": {"core", "scene", "motions", "splines", "profiles"},
    "solvers": {"core", "linear"},
    "input": {"core", "scene", "profiles/kinds"},
    "studies": {"core", "scene", "linear", "motions", "splines", "profiles", "objectives", "solvers", "input"},
    "report": {"core", "scene", "linear", "motions", "splines", "profiles", "objectives", "solvers", "input", "studies"},
}
# Kinds of cams: leaves, none of which knows another, so that each can be linked alone. Optimizer, studies and outputs
# ask a cam through scene/cam_mechanism.hpp and know no kind.
LEAVES = {"profiles/disk", "profiles/inverse", "profiles/linear", "profiles/remote", "profiles/spatial"}
MAY_INCLUDE |= {leaf: {"core", "scene", "profiles/kinds"} for leaf in LEAVES}
# The table of kinds: readers and lists link what kinds say of themselves, without formulas.
MAY_INCLUDE["profiles/kinds"] = {"core", "scene", "profiles"} | LEAVES
# The one place that knows them all: what a scene names becomes formulas. Optimizer and studies do without it.
MAY_INCLUDE["profiles/factory"] = {"core", "scene", "profiles", "profiles/kinds"} | LEAVES
# With the names of all laws and solvers, and formulas for every kind of cam: a scene one can solve.
MAY_INCLUDE["input/loading"] = {"core", "scene", "motions", "dynamics", "solvers", "input",
                                "profiles/factory"}
# Surfaces as meshes and pictures know no cam; what joins them with three-dimensional cams knows these by their flanks
# (scene/cam_flanks.hpp).
MAY_INCLUDE["report/surface"] = {"core"}
MAY_INCLUDE["report/spatial"] = {"core", "scene", "report", "report/surface"}
# Machines of several axes: what is about one axis does not know them.
MAY_INCLUDE["objectives/machine"] = MAY_INCLUDE["objectives"] | {"objectives"}
MAY_INCLUDE["studies/machine"] = MAY_INCLUDE["studies"] | {"studies", "objectives/machine"}
MAY_INCLUDE["report/machine"] = MAY_INCLUDE["report"] | {"report", "report/page", "studies/machine"}
# A measured cam: what solves a scene and writes its result does not know it.
MAY_INCLUDE["studies/inspect"] = MAY_INCLUDE["studies"] | {"studies"}
MAY_INCLUDE["report/inspect"] = MAY_INCLUDE["report"] | {"report", "report/page", "studies/inspect"}
# A page shows cams of every kind: of plane ones what their leaf says, of spatial ones what is drawn of them.
MAY_INCLUDE["report/page"] = MAY_INCLUDE["report"] | {"report", "report/spatial"}
# The shop: what a workshop or a controller takes. Nothing above it knows it. Programs and solids know no cam; an electronic cam
# is the motion alone.
MAY_INCLUDE["shop/nc"] = {"core", "scene", "input"}  # the rows of a post-processor's file
MAY_INCLUDE["shop/step"] = {"core", "report/surface"}
MAY_INCLUDE["shop/plc"] = {"core", "scene", "splines", "studies", "report"}
MAY_INCLUDE["shop/dxf"] = {"core", "scene", "report"}
MAY_INCLUDE["shop/sheet"] = {"core", "scene", "report", "shop/dxf"}
MAY_INCLUDE["shop/toolpath"] = {"core", "report", "shop/nc"}
MAY_INCLUDE["shop/disk"] = {"core", "scene", "profiles", "report", "report/surface", "shop/dxf", "shop/nc", "shop/sheet",
                             "shop/step"}
MAY_INCLUDE["shop/spatial"] = {"core", "scene", "report", "report/spatial", "report/surface", "shop/nc", "shop/sheet", "shop/step"}
MAY_INCLUDE["shop/exports"] = {"core", "scene", "input", "studies"} | {
    module for module in MAY_INCLUDE if module.startswith(("report", "shop/"))} | {"report/exports"}
# Every file of a solution by its name. Includes nothing of the shop, and links it where the build has it.
MAY_INCLUDE["report/exports"] = MAY_INCLUDE["report"] | {"report", "report/page", "shop/exports"}
EVERY_MODULE = set(MAY_INCLUDE)
MAY_INCLUDE |= {
    user: EVERY_MODULE for user in ("include", "apps", "benchmarks", "bindings", "examples", "notebooks_cpp", "tests")
}
# Nothing builds on the program; what of it can fail by itself (worker processes) is tested by itself.
MAY_INCLUDE["tests"] = EVERY_MODULE | {"apps", "bindings"}
MAY_INCLUDE["benchmarks"] = EVERY_MODULE | {"apps"}  # what of it costs time is measured by itself
MAY_INCLUDE["tests"] = MAY_INCLUDE["tests"] | {"benchmarks"}  # tests run the quick rows of the stability table

MAY_INCLUDE["cmake"] = set()  # what a compiler's runtime lacks (cmake/platforms/wasm): nothing of camopt


def module_of(path):
    """The module a file belongs to: its folder, or the leaf below it ("profiles/inverse")."""
    parts = pathlib.PurePosixPath(path).parts
    leaf = "/".join(parts[:2])
    return leaf if len(parts) > 2 and leaf in MAY_INCLUDE else parts[0]


CODE = {".cpp", ".hpp", ".c", ".h"}
LEFT_OUT = ("build", "out-", "node_modules", "__pycache__", ".")  # beginnings of names


def files(root):
    """Every file under root that belongs to the project, as paths relative to it."""
    root = pathlib.Path(root)
    for entry in sorted(root.iterdir()):
        if entry.name == ".ci" or not (entry.name == "out" or entry.name.startswith(LEFT_OUT)):
            if entry.is_dir():
                yield from (path.relative_to(root) for path in sorted(entry.rglob("*"))
                            if path.is_file() and "__pycache__" not in path.parts)
            else:
                yield entry.relative_to(root)


def code(root):
    return [path for path in files(root) if path.suffix in CODE]


def report(check, faults, seen):
    """Prints the faults; the exit status of a check. A check that saw nothing has failed too."""
    for fault in faults:
        print(fault)
    if not seen:
        faults = ["nothing to check"]
        print(f"{check}: found no file to check")
    print(f"{check}: {len(faults)} faults in {seen} files")
    sys.exit(1 if faults else 0)
