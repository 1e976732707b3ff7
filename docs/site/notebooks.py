# SPDX-License-Identifier: MIT
"""The notebooks of notebooks_cpp/ as pages: text, code and the outputs that are stored in them. Nothing is run."""

import re


def found_in(root):
    """Of each notebook's file its page on the site."""
    return {f"notebooks_cpp/{path.name}": f"notebooks/{path.stem}.md" for path in sorted((root / "notebooks_cpp").glob("*.ipynb"))}


def write(root, out, pages):
    """Writes the page of each; their names, in order."""
    notebooks = [root / path for path in found_in(root)]
    if not notebooks:
        print("site: NO NOTEBOOKS: notebooks_cpp has none, and the site has no page of them")
        return []
    import nbconvert  # only where there is something for it to do

    exporter = nbconvert.MarkdownExporter()
    folder = out / "notebooks"
    folder.mkdir(parents=True, exist_ok=True)
    for path in notebooks:
        resources = {"unique_key": path.stem, "output_files_dir": f"{path.stem}_files"}
        text, resources = exporter.from_filename(str(path), resources=resources)
        for name, data in resources["outputs"].items():
            target = folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
        text = pages.with_links_of_site(f"notebooks_cpp/{path.name}", cleaned(text, path))
        (folder / f"{path.stem}.md").write_text(text, encoding="utf-8")
    return [path.stem for path in notebooks]


def cleaned(text, path):
    """One title, C++ as C++, and where to find the notebook itself."""
    text = re.sub(r"^```(c\+\+\d*|c)$", "```cpp", text, flags=re.M | re.I)
    if not text.lstrip().startswith("# "):
        text = f"# {path.stem.replace('_', ' ')}\n\n{text}"
    return text.rstrip() + f"\n\n*The notebook: `notebooks_cpp/{path.name}`.*\n"


def index(names):
    if not names:
        return ("# Notebooks\n\nNo notebooks are in the tree that this site was built from.\n")
    listed = "\n".join(names)
    return (f"# Notebooks\n\nThe C++ notebooks of `notebooks_cpp/`, with the outputs that are stored in them.\n\n"
            f"```{{toctree}}\n:maxdepth: 1\n\n{listed}\n```\n")
