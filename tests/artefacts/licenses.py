# SPDX-License-Identifier: MIT
"""Whether the files of a release carry the licences of what they contain: the headers that their builds read (ninja -t deps)
belong to Debian packages, and each of these packages is a part that scripts/license_texts lists, with its text in the file."""

import importlib.machinery
import importlib.util
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Debian package of a header: part of scripts/license_texts, or None where nothing of it is passed on.
PART_OF_PACKAGE = {
    "libeigen3-dev": "eigen", "libfmt-dev": "fmt", "libtomlplusplus-dev": "toml++", "nlohmann-json3-dev": "nlohmann-json",
    "libcli11-dev": "cli11", "libcpp-httplib-dev": "cpp-httplib", "pybind11-dev": "pybind11", "libc++-22-dev-wasm32": "libc++",
    "libclang-common-22-dev": "libc++", "wasi-libc": "wasi-libc", "mingw-w64-x86-64-dev": "mingw-w64", "mingw-w64-common": "mingw-w64",
    "g++-mingw-w64-x86-64-posix": "gcc-mingw", "gcc-mingw-w64-x86-64-posix": "gcc-mingw",
    "gcc-mingw-w64-x86-64-posix-runtime": "gcc-mingw",
    # The C and C++ library of the system that a file is for.
    "libc6-dev": None, "linux-libc-dev": None, "libstdc++-12-dev": None, "libgcc-12-dev": None, "libcrypt-dev": None,
    # Declarations of shared libraries, which the Debian packages depend on.
    "coinor-libipopt-dev": None, "libnlopt-dev": None, "libcairo2-dev": None, "libssl-dev": None, "libbrotli-dev": None, "zlib1g-dev": None,
    "libpython3.11-dev": None, "python3-numpy": None, "libocct-foundation-dev": None, "libocct-modeling-data-dev": None,
    "libocct-modeling-algorithms-dev": None, "libocct-data-exchange-dev": None, "libocct-visualization-dev": None,
}
ON_DEBIAN = ("camopt", "camopt-parts", "camopt-step", "libcamopt-dev", "python3-camopt")  # which has the texts of common licences itself
# Objects of the parts, which are in packages of their own.
STEP = ("shop/step/CMakeFiles/camopt_part_",)
PARTS = ("solvers/ipopt/CMakeFiles/camopt_part_", "shop/sheet/pdf/CMakeFiles/camopt_part_", "apps/studio/CMakeFiles/camopt_part_")
# File of a release: its build folder below the clone, folders of it whose objects the file does not contain, and those whose objects
# alone it contains (empty: all).
BUILD = {
    "page": ("build/wasm", (), ()), "windows": ("build/windows", (), ()),
    "camopt": ("build/debian", ("bindings/", *PARTS, *STEP), ()), "camopt-parts": ("build/debian", (), PARTS),
    "camopt-step": ("build/debian", (), STEP),
    "libcamopt-dev": ("build/debian", ("apps/", "bindings/python/", *PARTS, *STEP), ()),
    "python3-camopt": ("build/debian", ("apps/", "bindings/c/", *PARTS, *STEP), ()), "wheel": ("build/setuptools", (), ()),
}


def license_texts():
    path = ROOT / "scripts/license_texts"
    loader = importlib.machinery.SourceFileLoader("license_texts", str(path))
    found = importlib.util.module_from_spec(importlib.util.spec_from_loader("license_texts", loader))
    loader.exec_module(found)
    return found


def headers_in(deps, folder, without=(), only=()):
    """Of the listing of `ninja -t deps` in folder: the headers outside of the project, as the objects read them."""
    headers, counts = set(), False
    for line in deps.splitlines():
        if not line.startswith(" "):
            counts = line.endswith("(VALID)") and not line.startswith(tuple(without)) and line.startswith(tuple(only) or "")
        elif counts:
            headers.add(pathlib.Path(folder, line.strip()).resolve())
    return {path for path in headers if path.is_relative_to("/usr")}


def packages_of(headers):
    """{Debian package: one header of it}; a header of no package is an error."""
    if not headers:
        return {}
    done = subprocess.run(["dpkg-query", "-S", *sorted(map(str, headers))], capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"scripts/release --check: headers of no package: {done.stderr.strip()}")
    found = {}
    for line in done.stdout.splitlines():
        names, _, header = line.partition(": ")
        for name in names.split(", "):
            found[name.split(":")[0]] = header
    return found


def headers_read(tree, file):
    folder, without, only = BUILD[file]
    builds = sorted(path.parent for path in (tree / folder).rglob("build.ninja")) if (tree / folder).is_dir() else []
    if not builds:
        raise SystemExit(f"scripts/release --check: {tree / folder} is missing, which tells what {file} contains: build it again")
    headers = set()
    for build in builds:
        deps = subprocess.run(["ninja", "-C", str(build), "-t", "deps"], capture_output=True, text=True, check=True).stdout
        headers |= headers_in(deps, build, without, only)
    return headers


def plain(text):
    return re.sub(r"\s+", " ", text)


def faults(file, text, packages):
    """`text`: the licences that the file carries; `packages`: {Debian package: a header of it that the build read}."""
    texts = license_texts()
    for package, header in sorted(packages.items()):
        part = PART_OF_PACKAGE.get(package, package)
        if part is not None and part not in texts.CONTENTS[file]:
            yield f"{file} contains {part} ({header} of {package}), which CONTENTS of scripts/license_texts lacks"
    if plain((ROOT / "LICENSE").read_text()) not in plain(text):
        yield f"{file} lacks the licence of camopt"
    for part in texts.CONTENTS[file]:
        if plain(texts.text_of(part)) not in plain(text):
            yield f"{file} lacks the licence of {part}"
        for name in () if file in ON_DEBIAN else texts.PARTS[part][2]:
            if plain((texts.COMMON / name).read_text(encoding="utf-8")) not in plain(text):
                yield f"{file} lacks the text of {name}, to which the licence of {part} refers"
