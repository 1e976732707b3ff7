# SPDX-License-Identifier: MIT
"""The reference of scene files, from what the program's reader checks against: `camopt list keys --json`."""

import json
import subprocess


def listed(program, what):
    run = subprocess.run([program, "list", what, "--json"], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def conditions(row):
    if row["cam_types"]:
        yield "Only where `cam.type` is " + " or ".join(f"`\"{kind}\"`" for kind in row["cam_types"]) + "."
    if row["instead_of"]:
        yield f"Instead of `{row['instead_of']}`."
    if row["needs"]:
        yield f"Needs a `[{row['needs']}]` table."


def key_section(row):
    names = ", ".join(f"`{key['key']}`" for key in row["keys"])
    units = [key["unit"] for key in row["keys"] if key["unit"]]
    facts = [f"**Allowed:** {row['allowed']}", f"**Default:** {row['default']}"]
    if units:
        facts.insert(0, f"**Unit:** {', '.join(units)}")
    anchor = f"key-{row['table'] or 'top'}-{row['name']}".replace(".", "-").replace("_", "-")
    text = " ".join([row["meaning"], *conditions(row)])
    return f"({anchor})=\n### {names}\n\n{text}\n\n{' · '.join(escaped(fact) for fact in facts)}\n"


def escaped(text):
    return text.replace("<", "\\<").replace("[", "\\[")


def page(program):
    parts = ["# Scene reference\n\nEvery key of a scene file, written by the program from the table that its reader checks against; "
             "`camopt list keys` prints the same. The unit stands in the key; each quantity is written once, in one of its units. "
             "What they are for: [The scene file](../docs/scene_file.md).\n"]
    table = None
    for row in listed(program, "keys"):
        if row["file"] != "scene":  # docs/machines.md, docs/nc.md
            continue
        if row["table"] != table:
            table = row["table"]
            parts.append(f"## {'Top level' if not table else f'`[{table}]`'}\n")
        parts.append(key_section(row))
    return "\n".join(parts)


def number(value):
    return "∞" if value is None else f"{value:.5g}"


def laws_page(program):
    rows = ["# Motion laws\n\nEvery law of the catalogue with its exact peaks, normalised by lift and rise: V, A, J are the largest "
            "\\|y'\\|, \\|y''\\|, \\|y'''\\|, Q the largest \\|y'·y''\\| (`camopt list laws`). ∞: the acceleration jumps.\n",
            "| key | law | V | A | J | Q | continuous up to derivative | source |", "|---|---|---|---|---|---|---|---|"]
    for law in listed(program, "laws"):
        peaks = [number(law.get(name)) for name in ("velocity", "acceleration", "jerk", "torque")]
        rows.append(f"| `{law['key']}` | {law['title']} | {' | '.join(peaks)} | {law['continuity']} | {law['source']} |")
    return "\n".join(rows) + "\n"


def solvers_page(program):
    rows = ["# Solvers\n\nWhat `solver.name` may be, with the options of each for `[solver.options]` (`camopt list solvers`), as the camopt has "
            "them that this site was built with.\n"]
    for solver in listed(program, "solvers"):
        where = f"version {solver['version']}" if solver["version"] else ("available" if solver["available"] else solver["remedy"])
        rows.append(f"## `{solver['name']}`\n\n{solver['method']}; {where}.\n")
        if solver["options"]:
            rows += ["| option | default | allowed | meaning |", "|---|---|---|---|"]
            rows += [f"| `{option['name']}` | {option['default']} | {option['range']} | {option['meaning']} |"
                     for option in solver["options"]]
            rows.append("")
    return "\n".join(rows) + "\n"
