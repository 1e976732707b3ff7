# SPDX-License-Identifier: MIT
"""exported_symbols.py NM LIBRARY HEADER: the library shows the functions that the header declares, and nothing else; its soname's
number is the header's CAMOPT_ABI_VERSION."""

import pathlib
import re
import subprocess
import sys

DECLARED = re.compile(r"^CAMOPT_C_API\b[^;(]*?\b(camopt_\w+)\(", re.MULTILINE)


def shown(nm, library):
    """Names of the defined dynamic symbols, without the version behind @ and the names of versions themselves."""
    lines = subprocess.run([nm, "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    symbols = [line.split()[-2:] for line in lines.splitlines()]
    return {name.split("@")[0] for kind, name in symbols if kind != "A"}


def main():
    nm, library, header = sys.argv[1:]
    text = pathlib.Path(header).read_text(encoding="utf-8")
    declared = set(DECLARED.findall(text))
    found = shown(nm, library)
    faults = [f"{name}: declared, and not in the library" for name in sorted(declared - found)]
    faults += [f"{name}: in the library, and not declared" for name in sorted(found - declared)]
    if len(declared) < 40 or text.count("CAMOPT_C_API camopt_error") >= len(declared):
        faults.append(f"only {len(declared)} declarations were recognised in the header")
    version = re.search(r"#define CAMOPT_ABI_VERSION (\d+)", text).group(1)
    if not pathlib.Path(library).name.endswith(f".so.{version}"):
        faults.append(f"{library}: its name does not end in CAMOPT_ABI_VERSION, {version}")
    print("\n".join(faults) or f"{len(found)} symbols, all of them declared")
    sys.exit(1 if faults else 0)


main()
