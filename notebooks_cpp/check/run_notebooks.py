# SPDX-License-Identifier: MIT
"""run_notebooks.py SESSION WORK [--write] [--html] [NAME …]: executes the notebooks of the folder above, top to bottom.

Compares with the outputs stored (outputs.py has the rules) and the numbers of the text with the outputs; --write stores
the new outputs instead of comparing. WORK gets the kernel's description, and with --html each notebook as a page.
Exit status 1 where anything differs or fails.
"""

import argparse
import copy
import os
import pathlib
import re
import sys
import time
from concurrent.futures import ThreadPoolExecutor

FOLDER = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(FOLDER / "check"), str(FOLDER / "kernel")]

import nbformat  # noqa: E402
from nbclient import NotebookClient  # noqa: E402
from nbclient.exceptions import CellExecutionError  # noqa: E402

import install_kernel  # noqa: E402
import outputs  # noqa: E402

CELL_SECONDS = 600
METADATA = {
    "kernelspec": {"display_name": "C++20 (camopt)", "language": "C++", "name": install_kernel.NAME},
    "language_info": {"codemirror_mode": "text/x-c++src", "file_extension": ".cpp", "mimetype": "text/x-c++src",
                      "name": "C++", "nbconvert_exporter": "script", "pygments_lexer": "cpp", "version": "20"},
}


def executed(path, notebook):
    result = copy.deepcopy(notebook)
    for cell in result.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    client = NotebookClient(result, timeout=CELL_SECONDS, kernel_name=install_kernel.NAME,
                            resources={"metadata": {"path": str(path.parent)}}, record_timing=False)
    client.execute()
    return tidy(result)


def tidy(notebook):
    """Nothing stored that changes from run to run, nor streams in as many pieces as they happened to come."""
    notebook.metadata = nbformat.from_dict(METADATA)
    for cell in notebook.cells:
        cell.metadata = nbformat.from_dict({})
        joined = []
        for output in cell.get("outputs", []):
            if joined and output.output_type == "stream" and joined[-1].output_type == "stream" and \
                    joined[-1].name == output.name:
                joined[-1].text += output.text
            else:
                joined.append(output)
        if cell.cell_type == "code":
            cell.outputs = joined
    return notebook


def page_of(notebook, title):
    """As HTML. What Debian's nbconvert takes out of a page as unsafe is every line of a picture: these are ours."""
    from nbconvert import HTMLExporter
    exporter = HTMLExporter()
    exporter.register_filter("clean_html", lambda text: text)
    page, _ = exporter.from_notebook_node(notebook, {"metadata": {"name": title}})
    return re.sub(r'<script src="https?://[^>]*></script>', "", page)  # formulas, of which there are none


def faults_of(path, options):
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    try:
        now = executed(path, notebook)
    except CellExecutionError as error:
        return [f"a cell failed\n{error}"]
    if options.html:
        (pathlib.Path(options.work) / f"{path.stem}.html").write_text(page_of(now, path.stem), encoding="utf-8")
    if options.write:
        nbformat.write(now, path)
        return list(outputs.text_faults(now))
    faults = [f"cell {index}: {fault}" for index, (stored, new) in enumerate(zip(notebook.cells, now.cells))
              if stored.cell_type == "code" for fault in outputs.compare_cell(stored, new)]
    return faults + list(outputs.text_faults(now))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("session")
    parser.add_argument("work")
    parser.add_argument("names", nargs="*")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--html", action="store_true")
    options = parser.parse_intermixed_args()
    paths = sorted(FOLDER.glob("*.ipynb"))
    if options.names:
        wanted = [pathlib.Path(name).stem for name in options.names]  # "3" is enough for 3_….ipynb
        unknown = [name for name in wanted if not any(path.stem.startswith(name) for path in paths)]
        if unknown:
            sys.exit(f"no such notebook: {', '.join(unknown)}; there are {', '.join(path.stem for path in paths)}")
        paths = [path for path in paths if path.stem.startswith(tuple(wanted))]
    if not paths:
        sys.exit(f"no notebooks in {FOLDER}")
    work = pathlib.Path(options.work)
    work.mkdir(parents=True, exist_ok=True)
    install_kernel.install(options.session, work)
    os.environ["JUPYTER_PATH"] = str(work / "share" / "jupyter")
    bad = 0

    def timed(path):
        begin = time.monotonic()
        return path, faults_of(path, options), time.monotonic() - begin

    with ThreadPoolExecutor(max_workers=min(len(paths), os.cpu_count() or 1)) as pool:
        for path, faults, seconds in pool.map(timed, paths):
            bad += bool(faults)
            print(f"{path.stem}: {'FAILED' if faults else 'written' if options.write else 'as stored'}, {seconds:.1f} s")
            for fault in faults:
                print(f"    {fault}")
    print(f"{len(paths)} notebooks, {bad} with faults")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
