# SPDX-License-Identifier: MIT
"""The notebooks of the examples: every cell runs, and its outputs are those stored (notebooks_cpp/check/outputs.py).

CAMOPT_WRITE_DOCS=1 stores the new outputs instead of comparing.
"""

import json
import os
import pathlib
import re
import sys
import tempfile
import unittest

import program

try:
    import ipykernel  # noqa: F401
    import nbclient
    import nbformat
except ImportError as absent:
    print(f"*** SKIPPED: no notebook was run: {absent}")
    sys.exit(77)

sys.path.insert(0, str(program.ROOT / "notebooks_cpp/check"))
import outputs  # noqa: E402

FOLDER = program.ROOT / "bindings/python/examples"
KERNEL = "camopt-python"
METADATA = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
            "language_info": {"file_extension": ".py", "mimetype": "text/x-python", "name": "python"}}


def executed(path, work):
    """The notebook with the outputs of this interpreter; its files go into `work`."""
    spec = pathlib.Path(work, "share/jupyter/kernels", KERNEL)
    spec.mkdir(parents=True, exist_ok=True)
    command = [sys.executable, "-B", "-m", "ipykernel_launcher", "-f", "{connection_file}"]
    (spec / "kernel.json").write_text(json.dumps({"argv": command, "display_name": KERNEL, "language": "python"}))
    os.environ["JUPYTER_PATH"] = str(spec.parents[1])
    notebook = nbformat.read(path, as_version=4)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs = []
    nbclient.NotebookClient(notebook, timeout=120, kernel_name=KERNEL, resources={"metadata": {"path": work}},
                            record_timing=False).execute()
    notebook.metadata = nbformat.from_dict(METADATA)
    for cell in notebook.cells:
        cell.metadata = nbformat.from_dict({})
    return notebook


def without_styles(cell):
    """Colours and fonts of pictures are not what a notebook shows."""
    for output in cell.get("outputs", []):
        picture = output.get("data", {})
        if "image/svg+xml" in picture:
            picture["image/svg+xml"] = re.sub(r"<style>.*?</style>", "", picture["image/svg+xml"], flags=re.S)
    return cell


class Notebooks(unittest.TestCase):
    def test_they_run_and_give_what_is_stored(self):
        paths = sorted(FOLDER.glob("*.ipynb"))
        self.assertTrue(paths)
        for path in paths:
            with self.subTest(path.name), tempfile.TemporaryDirectory() as work:
                stored, now = nbformat.read(path, as_version=4), executed(path, work)
                nbformat.validate(now)
                if os.environ.get("CAMOPT_WRITE_DOCS"):
                    nbformat.write(now, path)
                    stored = now
                faults = [f"cell {index}: {fault}" for index, (old, new) in enumerate(zip(stored.cells, now.cells))
                          if old.cell_type == "code" for fault in outputs.compare_cell(without_styles(old), without_styles(new))]
                self.assertEqual(faults + list(outputs.text_faults(now)), [], "CAMOPT_WRITE_DOCS=1 stores new outputs")


if __name__ == "__main__":
    unittest.main(verbosity=2)
