# SPDX-License-Identifier: MIT
"""The checker as a module, and folders for it to look at."""
import importlib.machinery
import importlib.util
import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def load():
    """What scripts/verify-certificate runs, imported: many folders are judged in one process."""
    sys.path.insert(0, str(ROOT / "scripts"))
    return importlib.import_module("certificate_checker.verdict")


def load_exports():
    """scripts/verify-export, likewise."""
    load()
    path = str(ROOT / "scripts/verify-export")
    loader = importlib.machinery.SourceFileLoader("verify_export", path)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("verify_export", loader))
    loader.exec_module(module)
    return module


def solve(camopt, scene, folder, settings=()):
    """Solves a scene (a path, or its text) into the folder; returns the verdict."""
    folder = Path(folder)
    if not isinstance(scene, Path):
        text, scene = scene, folder.parent / (folder.name + ".toml")
        scene.write_text(text)
    command = [camopt, "solve", str(scene), "--out", str(folder)]
    for setting in settings:
        command += ["--set", setting]
    run = subprocess.run(command, capture_output=True, text=True, timeout=600)
    if run.returncode not in (0, 1, 3):
        raise AssertionError(f"{scene}: camopt ended with {run.returncode}: {run.stderr}")
    return json.loads((folder / "result.json").read_text())["verdict"]


class Silent:
    box_proof = None

    def say(self, text):
        pass


def outcome(module, folder, vipr=None, report=None):
    """("confirmed" | "refuted" | "not verified", why)."""
    code, why = module.outcome_of(Path(folder), report or Silent(), vipr)
    return {0: "confirmed", 1: "refuted", 2: "not verified"}[code], why


def end(faults):
    """Prints what is wrong; the exit code."""
    for fault in faults:
        print("FAULT:", fault)
    return 1 if faults else 0
