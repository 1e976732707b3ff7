# SPDX-License-Identifier: MIT
"""What the linker took, read from its map (-Wl,-Map=FILE)."""

import collections
import re

MEMBER = re.compile(r"^\S*libcamopt_(\w+)\.a\((\S+)\)")


def linked_objects(path):
    """How many object files of each camopt library the linker took."""
    members = set()
    for line in path.read_text(errors="replace").splitlines():
        found = MEMBER.match(line)
        if found:
            members.add(found.groups())
        if line.startswith("Memory Configuration"):
            break
    return collections.Counter(library for library, _ in sorted(members))
