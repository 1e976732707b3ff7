# SPDX-License-Identifier: MIT
"""A bare Debian of this machine's release, by debootstrap from this machine's mirror, to install packages in. Needs root."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

APT = pathlib.Path("/etc/apt")
WEEK = 7 * 24 * 3600


def run(words, **options):
    done = subprocess.run([str(word) for word in words], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False, **options)
    if done.returncode:
        print(done.stdout[-3000:], done.stderr[-3000:], sep="\n", file=sys.stderr)
        raise SystemExit(f"{' '.join(map(str, words))}: exit status {done.returncode}")
    return done.stdout


def missing():
    """Why there can be no chroot here; empty if there can."""
    if os.geteuid() != 0:
        return "not root"
    if not shutil.which("debootstrap"):
        return "no debootstrap (scripts/setup --release)"
    return "" if mirror() else "no mirror of this release in /etc/apt"


def codename():
    return re.search(r"^VERSION_CODENAME=(\w+)", pathlib.Path("/etc/os-release").read_text(), re.MULTILINE)[1]


def sources():
    """(URI, suite, components, keyring) of this machine's sources whose suites are of its Debian release."""
    found = []
    for path in [APT / "sources.list", *sorted((APT / "sources.list.d").glob("*.list"))]:
        lines = path.read_text().splitlines() if path.exists() else []
        for line in lines:
            match = re.match(r"deb\s+(?:\[([^\]]*)\]\s+)?(\S+)\s+(\S+)\s+(.*)", line)
            if match:
                keyring = re.search(r"signed-by=(\S+)", match[1] or "")
                found.append((match[2], match[3], match[4].split(), keyring[1] if keyring else ""))
    for path in sorted((APT / "sources.list.d").glob("*.sources")):
        for stanza in re.split(r"\n\s*\n", path.read_text()):
            fields = dict(re.findall(r"^([\w-]+):[ \t]*(.*)$", stanza, re.MULTILINE))
            if "deb" in fields.get("Types", "").split():
                found += [(uri, suite, fields.get("Components", "").split(), fields.get("Signed-By", ""))
                          for uri in fields["URIs"].split() for suite in fields["Suites"].split()]
    return [source for source in found if "main" in source[2] and re.match(rf"{codename()}(-|$)", source[1])]


def mirror():
    return next((source for source in sources() if source[1] == codename()), None)


def base(work):
    """The bare system, of this week; nothing is ever installed into it."""
    folder, mark = work / "bare", work / "bare.finished"
    if mark.exists() and time.time() - mark.stat().st_mtime < WEEK:
        return folder
    mark.unlink(missing_ok=True)
    shutil.rmtree(folder, ignore_errors=True)
    uri, suite, _, keyring = mirror()
    print(f"debootstrap of {suite}", flush=True)
    run(["debootstrap", "--variant=minbase", *([f"--keyring={keyring}"] if keyring else []), suite, folder, uri])
    mark.touch()
    return folder


class Chroot:
    """A copy of the bare system, removed at the end."""

    def __init__(self, work):
        self.folder = work / "chroot"
        self.base = base(work)

    def __enter__(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        run(["cp", "-a", "--reflink=auto", self.base, self.folder])
        etc = self.folder / "etc"
        lines = [f"deb {f'[signed-by={keyring}] ' if keyring else ''}{uri} {suite} main" for uri, suite, _, keyring in sources()]
        (etc / "apt/sources.list").write_text("\n".join(lines) + "\n")
        settings = re.findall(r"^Acquire::(?:http|https)::.*$", run(["apt-config", "dump"]), re.MULTILINE)
        (etc / "apt/apt.conf.d/99host").write_text("\n".join(settings) + "\n")
        shutil.copy("/etc/resolv.conf", etc / "resolv.conf")
        for path in ["/etc/ssl/certs/ca-certificates.crt", *[keyring for *_, keyring in sources() if keyring]]:
            target = self.folder / path.lstrip("/")
            if pathlib.Path(path).exists() and not target.exists():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, target)
        self.run("apt-get", "update")
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder, ignore_errors=True)

    def run(self, *words):
        environment = dict(os.environ, PATH="/usr/sbin:/usr/bin:/sbin:/bin", HOME="/root", LC_ALL="C.UTF-8", DEBIAN_FRONTEND="noninteractive")
        return run(["chroot", self.folder, *words], env=environment)

    def copy(self, path):
        shutil.copy(path, self.folder / "tmp")

    def package(self, name):
        return "/tmp/" + next((self.folder / "tmp").glob(f"{name}_*.deb")).name

    def install(self, name):
        self.run("apt-get", "install", "-y", "--no-install-recommends", self.package(name))

    def simulate(self, name):
        return self.run("apt-get", "install", "-s", "--no-install-recommends", self.package(name))

    def kilobytes(self):
        """Installed size of all packages, as they state it."""
        return sum(map(int, self.run("dpkg-query", "-W", "-f=${Installed-Size}\\n").split()))

    def has(self, command):
        return any((self.folder / folder / command).exists() for folder in ("usr/bin", "bin", "usr/sbin"))

    def has_file(self, path):
        return (self.folder / path).is_file()

    def files(self, *patterns):
        return [path for pattern in patterns for path in self.folder.glob(pattern)]
