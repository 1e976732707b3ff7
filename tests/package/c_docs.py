# SPDX-License-Identifier: MIT
"""c_docs.py PAGE FOLDER COMPILER [FLAG …]: every C block of a page compiles, as a program where it has a main, else as the body of
a function that has a scene and a solution; programs run too."""

import pathlib
import re
import subprocess
import sys

BLOCK = re.compile(r"^```c\n(.*?)^```$", re.MULTILINE | re.DOTALL)
BODY = """#include <camopt.h>
#include <stdio.h>
#include <stdlib.h>
void body(camopt_scene* scene, camopt_solution* solution);
void body(camopt_scene* scene, camopt_solution* solution) {{
    (void)scene;
    (void)solution;
    {{
{}
    }}
}}
"""


def main():
    page, folder, *command = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    blocks = BLOCK.findall(pathlib.Path(page).read_text(encoding="utf-8"))
    programs = 0
    for number, block in enumerate(blocks):
        source, binary = folder / f"block_{number}.c", folder / f"block_{number}"
        is_program = "int main(" in block
        source.write_text(block if is_program else BODY.format(block), encoding="utf-8")
        # Libraries stand behind what needs them.
        compiler, *flags = command
        subprocess.run([compiler, str(source), *([] if is_program else ["-c"]), "-o", str(binary), *flags], check=True)
        if is_program:
            programs += 1
            sys.stdout.write(subprocess.run([str(binary)], check=True, capture_output=True, text=True).stdout)
    if not blocks or not programs:
        sys.exit(f"{page}: found {len(blocks)} blocks and {programs} programs; at least one of each is meant")
    print(f"{len(blocks)} blocks compiled, {programs} run")


main()
