#!/usr/bin/env python3
"""The export to POV-Ray, proven: ten scenes rendered by lancer and, as `lancer convert` writes them, by POV-Ray.

    cargo build --release
    benches/povray.py                     the table; exit status 1 if a scene misses the mark
    benches/povray.py --keep FOLDER       leaves documents and pictures there

The scenes keep to what both programs can say: compose="add", sums below 1, constant reflectance, coefficients of which
POV-Ray has one number equal in all channels, no transparent object between a point and a lamp. The mark: off edges the
mean difference is at most 1 level of 255. An edge is a pixel of which some neighbour differs by more than 12 levels in
either picture; there the two cut their rays differently.

Python 3.9 or later and POV-Ray (Debian: povray), nothing else.
"""

import argparse
import math
import subprocess
import sys
import tempfile
from pathlib import Path

SIZE = (480, 360)
EDGE = 12

HEAD = """<scene version="1"><world ambient="0.2" background="0.12 0.16 0.24" compose="add" {world}/>
<material name="floor" ka="0.3 0.28 0.25" kd="0.4 0.38 0.34"/>
<material name="red" ka="0.3 0.05 0.05" kd="0.4 0.1 0.08" ks="0.2" n="40"/>
<material name="blue" ka="0.05 0.08 0.3" kd="0.1 0.15 0.4" ks="0.15" n="12"/>
<material name="mirror" ka="0.1" kd="0.1" ks="0.2" n="80" kr="0.5 0.45 0.4"/>
<material name="blinn" ka="0.1 0.2 0.1" kd="0.15 0.35 0.15" ks="0.25" n="60" highlight="blinn"/>
<material name="glass" ka="0" kd="0.04" kr="0.1" kt="0.8" index="1.5"/>
<material name="water" ka="0" kd="0.02" kt="0.9" index="1.33"/>
<material name="glow" ka="0.6 0.5 0.1" kd="0"/>
<light name="key" position="-4 6 5" color="0.7 0.68 0.6"/>
<light name="fill" position="5 3 4" color="0.2 0.22 0.3"/>
"""
FLOOR = '<plane name="floor" p0="0 0 0" p1="0 0 1" p2="1 0 0" material="floor"/>\n'
WALL = '<box name="wall" origin="-4 0 -3" u="8 0 0" v="0 3 0" w="0 0 -0.2" material="red"/>\n'


def torus(columns=24, rows=12):
    """Vertices and facets of a ring that is closed."""
    vertices, facets = [], []
    for i in range(columns):
        for j in range(rows):
            a, b = 2 * math.pi * i / columns, 2 * math.pi * j / rows
            r = 1 + 0.4 * math.cos(b)
            vertices.append((r * math.cos(a), 0.4 * math.sin(b), -r * math.sin(a)))
            k, l = (i + 1) % columns, (j + 1) % rows
            facets += [(i * rows + j, k * rows + j, k * rows + l), (i * rows + j, k * rows + l, i * rows + l)]
    return vertices, facets


def inline(attributes, parts=""):
    """The ring as an element."""
    vertices, facets = torus()
    numbers = lambda rows: "  ".join(" ".join(f"{x:.6g}" for x in row) for row in rows)
    return (f"<mesh {attributes}><vertices>{numbers(vertices)}</vertices>"
            f"<facets>{numbers(facets)}</facets>{parts}</mesh>\n")


def ring_obj():
    vertices, facets = torus()
    lines = ["v {:.6f} {:.6f} {:.6f}".format(*v) for v in vertices]
    lines += ["f {} {} {}".format(*(i + 1 for i in f)) for f in facets]
    return "\n".join(lines) + "\n"


def instances():
    places = [(x, z) for z in range(-2, 3) for x in range(-2, 3)]
    return "".join(
        f'<mesh src="ring.obj" scale="0.3 {0.3 + 0.05 * k / 24:.3f} 0.3" rotation="{k * 14} {k * 31} 0" '
        f'position="{x * 0.9} 0.6 {z * 0.9}" material="{["red", "blue", "blinn"][k % 3]}" smooth="true"/>\n'
        for k, (x, z) in enumerate(places))


# name: (attributes of the world, objects, attributes of the view)
SCENES = {
    "spheres": ("", FLOOR + '<sphere center="-1 0.8 0" radius="0.8" material="red"/>'
                '<sphere center="0.9 0.6 0.5" radius="0.6" material="blue"/>'
                '<sphere center="0.2 0.3 1.6" radius="0.3" material="glow"/>', ""),
    "boxes": ("", FLOOR + '<cube center="-1 0.6 0" edge="1.2" rotation="10 30 5" material="red"/>'
              '<box origin="0.5 0 0" u="1 0 0.2" v="0.3 1 0" w="0 0.1 -1" material="blue"/>'
              '<facet p0="-0.5 0.1 1.5" p1="0.5 0.1 1.3" p2="0.1 0.9 1" material="red"/>', ""),
    "cones": ("", FLOOR + '<cone base="-1.3 0 0" top="-1.3 1.6 0" base-radius="0.7" top-radius="0.2" material="red"/>'
              '<cone base="0.3 0.3 0.4" top="1.5 1.2 0" base-radius="0.3" top-radius="0.3" capped="false" '
              'material="blue"/><cone base="0.1 0 1.5" top="0.1 0.8 1.5" base-radius="0.4" top-radius="0" '
              'material="blinn"/>', ""),
    "mirrors": ('depth="5"', FLOOR + '<sphere center="-0.9 0.8 0" radius="0.8" material="mirror"/>'
                '<cube center="0.9 0.5 0.3" edge="1" rotation="0 25 0" material="mirror"/>'
                '<sphere center="0 0.25 1.3" radius="0.25" material="red"/>', ""),
    "glass": ('depth="8"', FLOOR + WALL + '<sphere center="-0.8 0.9 0.3" radius="0.8" material="glass"/>'
              '<cube center="1 0.65 0.6" edge="1" rotation="0 30 0" material="glass"/>', 'without="shadows"'),
    "nested": ('depth="10" index="1.2"', FLOOR + WALL + '<sphere center="0 1.1 0.4" radius="1" material="glass"/>'
               '<sphere center="0.1 1.1 0.4" radius="0.6" material="water"/>'
               '<cone base="-1.9 0.2 0.9" top="-1.9 1.4 0.9" base-radius="0.4" top-radius="0.3" material="water"/>',
               'without="shadows"'),
    "parts": ("", FLOOR + inline('material="red" position="0 1 0" rotation="60 20 0" scale="1 1.3 0.8"',
                                 '<part material="blue" facets="96 96"/><part material="mirror" facets="288 200"/>'), ""),
    "smooth": ("", FLOOR + inline('material="blinn" position="-0.6 1 0" rotation="70 0 20" smooth="true"')
               + inline('material="blue" position="1.2 0.7 0.9" rotation="30 50 0" scale="0.5 0.8 0.5" smooth="true"'),
               ""),
    "instances": ("", FLOOR + instances(), ""),
    "hidden": ('depth="6"', FLOOR + '<sphere center="-0.8 0.8 0" radius="0.8" material="blinn"/>'
               '<sphere center="0.9 0.6 0.5" radius="0.6" material="mirror"/>'
               '<sphere center="0 0.9 1.5" radius="0.8" material="red" visible="false"/>'
               '<light position="0 9 0" visible="false"/>', 'depth="2"'),
}


def ppm(path):
    """Width and samples of a binary PPM of 8 bits."""
    data = path.read_bytes()
    fields, at = [], 0
    while len(fields) < 4:
        end = at
        while data[end:end + 1] not in b" \t\r\n":
            end += 1
        word, at = data[at:end], end + 1
        if word.startswith(b"#"):
            at = data.index(b"\n", at - 1) + 1
        elif word:
            fields.append(word)
    return int(fields[1]), data[at:]


def compared(ours, theirs):
    """The mean difference off edges, its greatest, the share of pixels that are edges, the mean over all pixels."""
    (width, a), (_, b) = ppm(ours), ppm(theirs)
    height = len(a) // (3 * width)
    assert len(a) == len(b), "pictures of two sizes"
    off, count, worst, everywhere = 0, 0, 0, 0
    for y in range(height):
        for x in range(width):
            here = 3 * (y * width + x)
            apart = [abs(a[here + c] - b[here + c]) for c in range(3)]
            everywhere += sum(apart)
            beside = [3 * (j * width + i) for j in (y - 1, y, y + 1) for i in (x - 1, x, x + 1)
                      if 0 <= i < width and 0 <= j < height]
            if all(abs(p[n + c] - p[here + c]) <= EDGE for p in (a, b) for n in beside for c in range(3)):
                off, count, worst = off + sum(apart), count + 1, max(worst, *apart)
    pixels = width * height
    return off / max(1, 3 * count), worst, 1 - count / pixels, everywhere / (3 * pixels)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lancer", type=Path, default=Path(__file__).resolve().parent.parent / "target/release/lancer")
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--scenes", nargs="*", default=list(SCENES))
    arguments = parser.parse_args()
    missed, lancer = [], arguments.lancer.resolve()
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "ring.obj").write_text(ring_obj())
        print("| scene | mean off edges | greatest | edges | mean everywhere |\n|---|---|---|---|---|")
        for name in arguments.scenes:
            world, objects, view = SCENES[name]
            (folder / f"{name}.xml").write_text(HEAD.format(world=world) + objects + "</scene>\n")
            (folder / f"{name}.view.xml").write_text(
                f'<views version="1"><view name="front" width="{SIZE[0]}" height="{SIZE[1]}" {view}>'
                '<eye at="0.4 2 5.5" look-at="0 0.7 0" fov="42"/></view></views>\n')
            run = lambda *command: subprocess.run(command, cwd=folder, check=True, capture_output=True)
            run(lancer, f"{name}.xml", f"{name}.view.xml", f"{name}.ppm", "--binary", "--quiet")
            run(lancer, "convert", f"{name}.xml", f"{name}.pov")
            run("povray", f"{name}.pov", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "+FP", "-A", "-D", "-GA", "File_Gamma=1",
                f"+O{name}.pov.ppm")
            mean, worst, edges, everywhere = compared(folder / f"{name}.ppm", folder / f"{name}.pov.ppm")
            print(f"| {name} | {mean:.3f} | {worst} | {100 * edges:.1f} % | {everywhere:.3f} |", flush=True)
            if mean > 1:
                missed.append(name)
    if missed:
        sys.exit("more than 1 level: " + ", ".join(missed))


if __name__ == "__main__":
    main()
