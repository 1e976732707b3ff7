# SPDX-License-Identifier: MIT
"""Tests of finished artefacts, for scripts/release --check: each is installed as its user would, then solves a scene."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

import debian_chroot
import licenses

SCENE, SCENE_OBJECTIVE, CAM_SCENE = "drd_cubic_12.toml", "objective: 0.940489", "cam_roller.toml"
# Twelve cubic segments against the modified sine's own peaks (README.md), in Python and tests/package/consumer/solve.cpp.
OBJECTIVE = "0.93951"
# What every glibc system has. manylinux_2_35 sets the largest versions of their symbols.
SYSTEM_LIBRARIES = {"libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1", "ld-linux-x86-64.so.2"}
NEWEST_SYMBOLS = {"GLIBC": (2, 35), "GLIBCXX": (3, 4, 30), "CXXABI": (1, 3, 13), "GCC": (12, 0, 0)}
SOLVE_IN_PYTHON = ("import camopt; found = camopt.solve(weights=dict(v=.4, a=.4, j=.2), segments=12); "
                   "print(camopt.__version__, found.verdict, found.fun)")


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)
    if done.returncode:
        print(done.stdout[-3000:], done.stderr[-3000:], sep="\n", file=sys.stderr)
        raise SystemExit(f"{' '.join(map(str, words))}: exit status {done.returncode}")
    return done.stdout


def see(*words):
    """Runs a test that prints what it does; it may skip."""
    status = subprocess.run([str(word) for word in words], check=False).returncode
    if status:
        sys.exit(status if status == 77 else f"{' '.join(map(str, words))}: exit status {status}")


def demand(what, holds, found=""):
    print(f"{'passed' if holds else 'FAILED'}: {what}", flush=True)
    if not holds:
        raise SystemExit(f"scripts/release --check: {what}: found {found!r}")


def skip(why):
    print(f"*** SKIPPED: {why}")
    sys.exit(77)


def demand_no_path(folder, forbidden):
    """Reproducible elsewhere: no file names the folder that it was built in."""
    found = [path for path in folder.rglob("*") if path.is_file() and not path.is_symlink() and str(forbidden).encode() in path.read_bytes()]
    demand("no file names the build folder", not found, found)


def demand_licenses(file, text, work):
    found = list(licenses.faults(file, text, licenses.packages_of(licenses.headers_read(work / "tree", file))))
    demand(f"{file} carries the licences of what it contains", not found, found)


def joined(paths):
    return "\n".join(path.read_text(encoding="utf-8") for path in sorted(paths))


def fresh(work, name):
    folder = work / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


# The Debian packages.

def check_debian(files, version, root, work):
    files = {path.name.split("_")[0]: path for path in files}
    demand("five packages", set(files) == {"camopt", "camopt-parts", "camopt-step", "libcamopt-dev", "python3-camopt"}, files)
    print(run("lintian", "--fail-on", "error", *files.values()), end="")
    demand("lintian finds no error", True)
    folder = fresh(work, "extracted")
    for path in files.values():
        run("dpkg-deb", "-x", path, folder)
    demand_no_path(folder, work.parent)
    for name in files:
        demand_licenses(name, (folder / "usr/share/doc" / name / "copyright").read_text(encoding="utf-8"), work)
    demand("camopt has the page", (folder / "usr/share/camopt/camopt.html").exists())
    check_library(folder / "usr", version, root, work)
    check_in_chroot(files, version, root, work)


def check_library(prefix, version, root, work):
    """libcamopt-dev, extracted: a CMake project of C++, and a program in C by pkg-config."""
    build = fresh(work, "consumer")
    run("cmake", "-S", root / "tests/package/consumer", "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
        "-DCAMOPT_KIND=static", f"-DCAMOPT_VERSION={version}", f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", build, "--target", "one_component", "solve")
    printed = run(build / "solve")
    demand("a C++ program of libcamopt-dev solves", OBJECTIVE in printed, printed)
    library = next(prefix.glob("lib/*/libcamopt_c.so")).parent
    source = build / "version.c"
    source.write_text('#include <camopt.h>\n#include <stdio.h>\nint main(void) { puts(camopt_version()); return 0; }\n')
    flags = run("pkg-config", "--cflags", "--libs", "camopt_c", env=dict(os.environ, PKG_CONFIG_PATH=str(library / "pkgconfig"))).split()
    run("cc", "-std=c99", source, "-o", build / "version", *flags)
    printed = run(build / "version", env=dict(os.environ, LD_LIBRARY_PATH=str(library)))
    demand("a C program of libcamopt-dev runs", version in printed, printed)


def check_in_chroot(files, version, root, work):
    why = debian_chroot.missing()
    if why:
        skip(f"{why}; not tested in a bare Debian")
    with debian_chroot.Chroot(work) as chroot:
        demand("no compiler in the bare system", not chroot.has("g++") and not chroot.has("cc"))
        for path in files.values():
            chroot.copy(path)
        for scene in (SCENE, CAM_SCENE):
            chroot.copy(root / "scenes" / scene)
        before = chroot.kilobytes()
        chroot.install("camopt")
        demand("apt-get installs camopt", True)
        after = chroot.kilobytes()
        print(f"camopt and its dependencies: {(after - before) / 1e3:.0f} MB")
        printed = chroot.run("camopt", "--version")
        demand("camopt --version", printed.startswith(f"camopt {version}\n") and "may be distributed under the MIT license" in printed, printed)
        printed = chroot.run("camopt", "solve", f"/tmp/{SCENE}", "--out", "/tmp/result")
        demand("camopt solves and writes a report", SCENE_OBJECTIVE in printed and chroot.has_file("tmp/result/report.html"), printed)
        demand("manual page and completions", all(map(chroot.has_file, (
            "usr/share/man/man1/camopt.1.gz", "usr/share/bash-completion/completions/camopt", "usr/share/zsh/vendor-completions/_camopt",
            "usr/share/fish/vendor_completions.d/camopt.fish"))))
        demand("without camopt-parts it says what to install", "install the Debian package camopt-parts" in chroot.run("camopt", "list", "solvers"))
        chroot.install("camopt-parts")
        print(f"camopt-parts and its dependencies: {(chroot.kilobytes() - after) / 1e3:.0f} MB")
        chroot.run("camopt", "solve", f"/tmp/{SCENE}", "--solver", "ipopt")
        chroot.run("camopt", "export", f"/tmp/{CAM_SCENE}", "--drawing", "pdf", "--out", "/tmp/drawing")
        demand("camopt-parts has Ipopt and PDF drawings", chroot.has_file("tmp/drawing/drawing.pdf"))
        after = chroot.kilobytes()
        chroot.install("camopt-step")
        print(f"camopt-step and its further dependencies: {(chroot.kilobytes() - after) / 1e3:.0f} MB")
        chroot.run("camopt", "export", f"/tmp/{CAM_SCENE}", "--step", "--out", "/tmp/solid")
        demand("camopt-step writes STEP files", chroot.has_file("tmp/solid/cam.step"))
        after = chroot.kilobytes()
        chroot.install("python3-camopt")
        print(f"python3-camopt and its further dependencies: {(chroot.kilobytes() - after) / 1e3:.0f} MB")
        printed = chroot.run("python3", "-c", SOLVE_IN_PYTHON)
        demand("python3-camopt solves", printed.startswith(f"{version} optimal {OBJECTIVE}"), printed)
        printed = chroot.simulate("libcamopt-dev")
        demand("the dependencies of libcamopt-dev exist", "Inst libcamopt-dev" in printed, printed)
        chroot.run("apt-get", "remove", "-y", "camopt", "python3-camopt", "camopt-parts", "camopt-step")
        left = [path for path in chroot.files("usr/bin/camopt*", "usr/lib/*/camopt*", "usr/lib/python3/dist-packages/camopt*", "usr/share/doc/*camopt*")]
        demand("apt-get remove leaves nothing", not left, left)


# The wheel.

def check_wheel(files, version, root, work):
    wheel, = files
    folder = fresh(work, "wheel")
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
        archive.extractall(folder / "content")
    demand("stubs", {"camopt/_camopt.pyi", "camopt/py.typed"} <= names, names)
    info = f"camopt-{version}.dist-info"
    demand_licenses("wheel", joined((folder / "content" / info).glob("LICENSE*")), work)
    needs = re.findall(r"^Requires-Dist: (.*)$", (folder / "content" / info / "METADATA").read_text(), re.MULTILINE)
    demand("NumPy is the only requirement", [need for need in needs if "extra ==" not in need] == ["numpy"], needs)
    demand_no_path(folder / "content", work.parent)
    extension = next((folder / "content/camopt").glob("_camopt*.so"))
    dynamic = run("readelf", "--wide", "--dynamic", extension)
    libraries = set(re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic))
    demand("libraries of the system alone", libraries <= SYSTEM_LIBRARIES, libraries)
    symbols = set(re.findall(r"Name: ([A-Z]+)_([0-9.]+)", run("readelf", "--wide", "--version-info", extension)))
    newer = [symbol for symbol in symbols if tuple(map(int, symbol[1].split("."))) > NEWEST_SYMBOLS.get(symbol[0], (99,))]
    demand("symbols of manylinux_2_35", not newer, newer)
    print("newest glibc symbols:", max((tuple(map(int, number.split("."))) for name, number in symbols if name == "GLIBC")))

    # An environment that has Python's own library and NumPy, nothing else.
    numpy = pathlib.Path(run("/usr/bin/python3", "-c", "import numpy; print(numpy.__path__[0])").strip())
    (folder / "numpy").mkdir()
    for path in numpy.parent.glob("numpy*"):
        (folder / "numpy" / path.name).symlink_to(path)
    run("/usr/bin/python3", "-m", "venv", folder / "environment")
    python = folder / "environment/bin/python"
    environment = {"PATH": os.environ["PATH"], "HOME": str(folder), "PYTHONPATH": str(folder / "numpy")}
    run(python, "-m", "pip", "install", "--quiet", "--no-index", "--disable-pip-version-check", wheel, env=environment)
    printed = run(python, "-c", SOLVE_IN_PYTHON, cwd=folder, env=environment)
    demand("import and solve", printed.startswith(f"{version} optimal {OBJECTIVE}"), printed)
    printed = run(python, "-c", "import camopt, sys; print(camopt.__file__, *[name for name in ('scipy', 'fmt') if name in sys.modules])",
                  cwd=folder, env=environment).split()
    demand("the installed package is used", len(printed) == 1 and printed[0].startswith(str(folder / "environment")), printed)


# Windows, under Wine, compared with camopt of this machine.

def check_windows(files, version, root, work, program):
    folder = fresh(work, "unpacked")
    with zipfile.ZipFile(next(path for path in files if path.suffix == ".zip")) as archive:
        archive.extractall(folder)
    demand_licenses("windows", joined((folder / "licenses").glob("*.txt")), work)
    demand("the page", (folder / "camopt.html").exists())
    demand_no_path(folder, work.parent)
    setup = next(path for path in files if path.name.endswith("-setup.exe"))
    tests = root / "build/release/tests/apps/apps_test"
    if not tests.exists():
        print(f"*** the command-line tests do NOT run under Wine: {tests} is not built")
    see("/usr/bin/python3", "-B", root / "tests/artefacts/windows_checks.py", folder / "camopt.exe", program(), work / "wine", "--setup", setup,
        *(["--tests", tests] if tests.exists() else []))


# The page: one file that fetches nothing; then every example of it in a browser, compared with camopt of this machine.

def check_page(files, version, root, work, program):
    page, = files
    text = page.read_text(encoding="utf-8")
    demand("an HTML document", text.lstrip()[:15].lower() == "<!doctype html>", text[:60])
    outside = re.findall(r"<(?:script|img|iframe|link)\b[^>]*\b(?:src|href)\s*=\s*[\"']?(?!data:|blob:|#)[^\"'> ]+", text)
    demand("nothing is fetched", not outside, outside[:3])
    demand_licenses("page", re.search(r'<script type="text/plain" id="licences">(.*?)</script>', text, re.DOTALL)[1], work)
    see("/usr/bin/python3", "-B", root / "scripts/check_offline_page", page, program())


# The sources.

def check_source(files, version, root, work):
    archive, = files
    folder = fresh(work, "source")
    with tarfile.open(archive) as tar:
        tar.extractall(folder)
    top = folder / f"camopt-{version}"
    tracked = set(run("git", "ls-tree", "-r", "--name-only", "-z", "HEAD", cwd=root).split("\0")) - {""}
    found = {path.relative_to(top).as_posix() for path in top.rglob("*") if path.is_file() or path.is_symlink()}
    demand("the files of the commit", tracked == found, sorted(tracked ^ found)[:5])
    lacking = list(licenses.faults("source", joined([top / "LICENSE", *top.glob("report/page/vendor/*.LICENSE")]), {}))
    demand("source carries the licences of what it contains", not lacking, lacking)
    run("cmake", "--preset", "minimal", "-DCAMOPT_BUILD_TESTS=OFF", "-DCAMOPT_BUILD_BENCHMARKS=OFF", cwd=top)
    demand("CMake configures them", True)
    run("cmake", "--build", "--preset", "minimal", "--target", "camopt_core", cwd=top)
    demand("core builds", True)


def check(name, files, version, root, work, program):
    """program(): a camopt of this machine and commit."""
    globals()[f"check_{name}"](files, version, root, work, *([program] if name in ("page", "windows") else []))
