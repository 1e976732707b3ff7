# SPDX-License-Identifier: MIT
"""The gallery: every example scene with what the program makes of it. A scene is solved again only where it or the program
has changed."""

import concurrent.futures
import hashlib
import html
import json
import pathlib
import re
import shutil
import subprocess
import tomllib

# Enough for all but the hardest, whose pages say what they came to within it; where that is nothing the next is tried.
MOST_SECONDS = (8, 60)
# Best first: what shows a scene at a glance.
COVERS = ["timing.svg", "cam.svg", "mechanism.svg", "guide.svg", "profile.svg", "motion.svg"]
CAPTIONS = {"timing.svg": "All axes and clearances over one revolution of the master", "drive.svg": "The motor",
            "motion.svg": "The motion found", "profile.svg": "The cam", "profile_diagrams.svg": "Pressure angle and curvature",
            "mechanism.svg": "The mechanism", "guide.svg": "The guide", "cam.svg": "The cam", "curvature.svg": "Curvature",
            "pressure_angle.svg": "Pressure angle"}
GROUPS = [("Motions between dwells", "drd_"), ("Rise and return", "rr_"), ("Disk cams", "cam_"), ("Cams with a linkage", "tappet_"),
          ("Plates that slide", "linear_"), ("Cams that exist", "given_"),
          ("Cams in three dimensions", ("barrel_", "cylinder_", "ocrf_")), ("Others", "")]
MACHINES = "Machines of several axes"


def is_machine(scene):
    return "machine" in tomllib.loads(scene.read_text(encoding="utf-8"))


def axes_of(machine):
    """The scene files of a machine's axes."""
    return [machine.parent / axis["scene"] for axis in tomllib.loads(machine.read_text(encoding="utf-8"))["axis"]]


def digest(program, scene):
    axes = b"".join(axis.read_bytes() for axis in axes_of(scene)) if is_machine(scene) else b""
    return hashlib.sha256(pathlib.Path(program).read_bytes() + scene.read_bytes() + axes + str(MOST_SECONDS).encode()).hexdigest()


def words_of_call(scene, seconds):
    """The subcommand and the options behind the scene's name."""
    return ("machine", ["--max-seconds", str(seconds)]) if is_machine(scene) else (
        "solve", ["--set", f"solver.max_seconds={seconds}"])


def solved(program, scene, folder):
    """What the program said, and the seconds it had; from `folder` where that is current."""
    stamp = folder / "stamp.json"
    now = digest(program, scene)
    if stamp.exists() and json.loads(stamp.read_text())["digest"] == now:
        return json.loads(stamp.read_text())
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for seconds in MOST_SECONDS:
        command, options = words_of_call(scene, seconds)
        run = subprocess.run([program, command, scene, "--out", folder / "result", *options],
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if run.returncode in (0, 3):
            break
    if run.returncode not in (0, 3):
        raise SystemExit(f"site: camopt {command} {scene} ended with {run.returncode}: {run.stdout[-1000:]}")
    cam = tomllib.loads(scene.read_text()).get("cam", {})
    if run.returncode == 0 and cam.get("type") in ("barrel", "cylindrical"):
        subprocess.run([program, "export", folder / "result", "--out", folder / "result", "--picture"], check=True,
                       stdout=subprocess.DEVNULL)
    # Which files it wrote where is of no interest here.
    words = "\n".join(line for line in run.stdout.split("\n") if not line.lstrip().startswith("wrote "))
    facts = {"digest": now, "words": words, "seconds": seconds}
    stamp.write_text(json.dumps(facts))
    return facts


def by_number(scene):
    """drd_cubic_4 before drd_cubic_10."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", scene.stem)]


def comment_of(text):
    """The lines below the title that say why the scene is there."""
    lines = [line[1:].strip() for line in text.split("\n") if line.startswith("#")]
    return " ".join(lines[: next((n for n, line in enumerate(lines) if not line), len(lines))])


class Gallery:
    def __init__(self, root, out, cache, program):
        self.root, self.out, self.cache, self.program = root, out, cache, program
        files = sorted((root / "scenes").glob("**/*.toml"), key=by_number)
        axes = {axis for file in files if is_machine(file) for axis in axes_of(file)}
        self.scenes = [file for file in files if file not in axes]  # an axis stands on its machine's page

    def places(self):
        """Of each scene's file its page on the site."""
        files = [(scene, file) for scene in self.scenes for file in [scene, *(axes_of(scene) if is_machine(scene) else [])]]
        return {str(file.relative_to(self.root)): f"gallery/{scene.stem}.md" for scene, file in files}

    def solve_all(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            facts = pool.map(lambda scene: solved(self.program, scene, self.cache / scene.stem), self.scenes)
            return dict(zip(self.scenes, facts))

    def pictures(self, scene):
        """Copied beside the pages, each under the scene's name."""
        names = []
        for picture in sorted((self.cache / scene.stem / "result").glob("*.svg")):
            target = self.out / "gallery" / f"{scene.stem}_{picture.name}"
            shutil.copy(picture, target)
            names.append(picture.name)
        return sorted(names, key=lambda name: COVERS.index(name) if name in COVERS else len(COVERS))

    def write(self):
        (self.out / "gallery").mkdir(parents=True, exist_ok=True)
        facts = self.solve_all()
        cards = {title: [] for title in [*(title for title, _ in GROUPS[:-1]), MACHINES, GROUPS[-1][0]]}
        for scene in self.scenes:
            text = scene.read_text(encoding="utf-8")
            title = tomllib.loads(text)["title"]
            pictures = self.pictures(scene)
            group = MACHINES if is_machine(scene) else next(title for title, prefix in GROUPS if scene.stem.startswith(prefix))
            cards[group].append(card(scene, title, pictures))
            (self.out / "gallery" / f"{scene.stem}.md").write_text(scene_page(scene, scene.relative_to(self.root), title, text,
                                                                              pictures, facts[scene]), encoding="utf-8")
        (self.out / "gallery/index.md").write_text(index_page(cards, self.scenes), encoding="utf-8")
        return len(self.scenes)


def card(scene, title, pictures):
    # Sphinx puts the pictures of all pages into one folder.
    cover = f'<img src="../_images/{scene.stem}_{pictures[0]}" alt="" loading="lazy">' if pictures else (
        '<span class="words">proved infeasible: nothing to draw</span>')
    return f'<a href="{scene.stem}.html">{cover}{html.escape(title)}</a>'


def index_page(cards, scenes):
    parts = ["# Gallery\n\nEvery example of `scenes/`, solved while this site was built. Each page has the scene, what the program said, "
             "and its pictures.\n"]
    for title, group in cards.items():
        if group:
            parts.append(f"## {title}\n\n<div class=\"gallery\">\n" + "\n".join(group) + "\n</div>\n")
    names = "\n".join(scene.stem for scene in scenes)
    return "\n".join(parts) + f"\n```{{toctree}}\n:hidden:\n\n{names}\n```\n"


def scene_page(scene, name, title, text, pictures, facts):
    parts = [f"# {title}\n\n{comment_of(text)}\n"]
    parts += [f"![{CAPTIONS.get(one, one)}]({scene.stem}_{one})\n" for one in pictures]
    parts.append(f"## Scene\n\n`{name}`:\n\n```toml\n{text}```\n")
    if is_machine(scene):
        parts += [f"`{name.parent / axis.name}`:\n\n```toml\n{axis.read_text(encoding='utf-8')}```\n" for axis in axes_of(scene)]
    command, options = words_of_call(scene, facts["seconds"])
    parts.append(f"## Result\n\n`camopt {command} {name} {' '.join(options)}` says:\n\n"
                 f"```text\n{facts['words'].rstrip()}\n```\n")
    return "\n".join(parts)
