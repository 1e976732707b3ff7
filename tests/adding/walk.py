# SPDX-License-Identifier: MIT
"""The pages docs/adding_*.md, walked: what they say is done, with the files they name and no others.

walk.py ROOT check          every edit is in a file its page names, fits the tree, and no more files are touched than a
                            thing may (most_files) (a test of ctest)
walk.py ROOT build FOLDER   copies the tree there, does all of it, builds camopt and runs what each adds
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import tomllib

HERE = pathlib.Path(__file__).parent


def things():
    for path in sorted(HERE.glob("*.toml")):
        yield path.stem, tomllib.loads(path.read_text())


def is_named(file: str, page: str) -> bool:
    """By its path, or by its name alone beside a path of its folder; <name> in a page is any name."""
    page = page.replace("<name>", "dummy")
    return file in page or f"`{pathlib.PurePath(file).name}`" in page


def faults(root: pathlib.Path, name: str, thing: dict) -> list[str]:
    page = root / thing["page"]
    if not page.exists():
        return [f"{name}: there is no {thing['page']}"]
    text = page.read_text()
    found = [f"{name}: {thing['page']} does not name {part['file']}"
             for part in thing.get("edit", []) + thing.get("new", []) if not is_named(part["file"], text)]
    for edit in thing.get("edit", []):
        times = (root / edit["file"]).read_text().count(edit["find"])
        if times != 1:
            found.append(f"{name}: {edit['file']} has {times} times, not once: {edit['find']!r}")
    files = {part["file"] for part in thing.get("edit", []) + thing.get("new", [])}
    if len(files) > thing.get("most_files", len(files)):
        found.append(f"{name}: touches {len(files)} files; allowed: {thing['most_files']}: {', '.join(sorted(files))}")
    if not thing.get("run"):
        found.append(f"{name}: nothing is run")
    return found


def check(root: pathlib.Path) -> int:
    all_things = dict(things())
    found = [fault for name, thing in all_things.items() for fault in faults(root, name, thing)]
    walked = {thing["page"] for thing in all_things.values()}
    for page in sorted((root / "docs").glob("adding_*.md")):
        if f"docs/{page.name}" not in walked:
            found.append(f"docs/{page.name}: no test walks it")
    print("\n".join(found + [f"adding: {len(found)} faults in {len(all_things)} pages"]))
    return 1 if found else 0


def do(root: pathlib.Path, thing: dict):
    for part in thing.get("new", []):
        path = root / part["file"]
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(part["text"].lstrip("\n"))
    for edit in thing.get("edit", []):
        path = root / edit["file"]
        path.write_text(path.read_text().replace(edit["find"], edit["with"].removeprefix("\n")))


def run(camopt: pathlib.Path, name: str, one: dict, folder: pathlib.Path) -> list[str]:
    if "scene" in one:
        (folder / "scene.toml").write_text(one["scene"])
    done = subprocess.run([camopt, *one["arguments"]], cwd=folder, capture_output=True, text=True)
    words, said = " ".join(one["arguments"]), done.stdout + done.stderr
    found = []
    if done.returncode != one.get("status", 0):
        found.append(f"{name}: camopt {words} ends with {done.returncode}:\n{said}")
    found += [f"{name}: camopt {words} does not say {text!r}:\n{said}"
              for text in one.get("says", []) if text not in said]
    found += [f"{name}: camopt {words} does not write {file}"
              for file in one.get("writes", []) if not (folder / file).exists()]
    return found


def build(root: pathlib.Path, folder: pathlib.Path) -> int:
    source = folder / "source"
    shutil.rmtree(source, ignore_errors=True)
    list_files = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    files = subprocess.run(list_files, cwd=root, check=True, capture_output=True, text=True)
    for file in files.stdout.splitlines():
        if (root / file).exists():
            (source / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(root / file, source / file)
    for _, thing in things():
        do(source, thing)
    subprocess.run([source / "scripts/build", "release", "apps/all"], cwd=source, check=True)
    found = []
    for name, thing in things():
        with tempfile.TemporaryDirectory() as place:
            for one in thing["run"]:
                found += run(source / "build/release/apps/camopt", name, one, pathlib.Path(place))
        print(f"adding: {name} walked")
    print("\n".join(found + [f"adding: {len(found)} faults"]))
    return 1 if found else 0


def main() -> int:
    root = pathlib.Path(sys.argv[1]).resolve()
    if sys.argv[2] == "build":
        return build(root, pathlib.Path(sys.argv[3]).resolve())
    return check(root)


if __name__ == "__main__":
    sys.exit(main())
