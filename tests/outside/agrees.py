#!/usr/bin/env python3
"""Does lancer agree with the naive implementation beside this file?

    python3 agrees.py LANCER_BINARY [SCENE ...]

Every scene of SCENES is rendered by both at a reduced size. Each channel of each pixel must agree within one level of 255,
but for edge pixels: there the naive implementation, sampled at 9 positions within 1/8 pixel of every sample position, spans
lancer's value when widened by one level. Edge pixels may be at most EDGES of a picture. One line per scene; exit code 1 on
any disagreement.
"""
import os
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ET

import naive_whitted as naive
import numpy as np
from document import read_scene, read_view

SCENES = [  # scene, view (None: the first), size; together they use every part of the model
    ("first/first", None, (160, 100)),                      # mirror, glass, shadows, samples
    ("course/figure3", "front", (120, 90)),                 # a box of glass, total reflection inside it
    ("course/objects", None, (160, 80)),                    # every shape, parts of a mesh, what is not visible
    ("course/steps", "3 reflection", (160, 120)),           # a step left out
    ("gallery/nested", None, (160, 80)),                    # the stack of media
    ("gallery/pond", "below", (160, 107)),                  # a half-space of water with the eye in it
    ("gallery/mirrors", None, (120, 90)),                   # depth 16
    ("gallery/knot", None, (120, 90)),                      # smooth normals, mirrored
    ("teaching/channels", None, (160, 67)),                 # shininess, coefficients and index per channel
    ("teaching/compose-add", None, (120, 90)),
    ("teaching/compose-screen-each", None, (120, 90)),
    ("teaching/highlights", None, (160, 87)),               # Phong and Blinn
    ("teaching/laws", None, (160, 67)),                     # constant, schlick, grazing
    ("teaching/depth", "depth 2", (120, 90)),               # the view's depth instead of the world's
]
EDGES = 0.001
SHOWN = 5
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scenes")


def reduced(path, wanted, size, out):
    """A views document that holds one view of another, at another size."""
    root = ET.parse(path).getroot()
    view = next(v for v in root.iter("view") if wanted is None or v.get("name") == wanted)
    view.set("width", str(size[0]))
    view.set("height", str(size[1]))
    views = ET.Element("views", version="1")
    views.append(view)
    ET.ElementTree(views).write(out, encoding="UTF-8", xml_declaration=True)


def read_ppm(path):
    with open(path, encoding="ascii") as file:
        words = " ".join(line.split("#")[0] for line in file).split()
    width, height, most = map(int, words[1:4])
    assert words[0] == "P3" and most == 255, words[:4]
    return np.array(words[4:], int).reshape(height, width, 3)


def span(tracer, view, pixels):
    """The least and the greatest bytes of some pixels when every sample moves to 9 positions within 1/8 pixel of itself."""
    low = high = 0
    for x, y in naive.centres(view):
        seen = [tracer.look(view, x[pixels] + dx, y[pixels] + dy) for dy in (-0.125, 0, 0.125) for dx in (-0.125, 0, 0.125)]
        low, high = low + np.min(seen, 0), high + np.max(seen, 0)
    return naive.byte(low / view.samples ** 2), naive.byte(high / view.samples ** 2)


def compare(binary, scene, wanted, size, folder):
    """-> whether all is well; prints the line of this scene."""
    start = time.time()
    scene_path, view_path = os.path.join(ROOT, scene + ".xml"), os.path.join(folder, "one.view.xml")
    reduced(os.path.join(ROOT, scene + ".view.xml"), wanted, size, view_path)
    view = read_view(view_path)
    tracer = naive.Tracer(read_scene(scene_path), view.depth, view.without)
    ours = naive.render(tracer, view).reshape(-1, 3)
    out = os.path.join(folder, "out.ppm")
    done = subprocess.run([binary, scene_path, view_path, out], capture_output=True, text=True)
    name = f"{scene} {wanted or ''}".strip()
    if done.returncode != 0:
        print(f"{name:32} FAILED: exit code {done.returncode}\n{done.stderr}")
        return False
    theirs = read_ppm(out)
    if theirs.shape != (view.height, view.width, 3):
        print(f"{name:32} FAILED: the picture is {theirs.shape}")
        return False
    theirs = theirs.reshape(-1, 3)
    differ = np.flatnonzero((np.abs(ours - theirs) > 1).any(1))
    bad = differ
    if len(differ):
        low, high = span(tracer, view, differ)
        bad = differ[((theirs[differ] < low - 1) | (theirs[differ] > high + 1)).any(1)]
    well = len(bad) == 0 and len(differ) <= EDGES * len(ours)
    exact = 100 * np.mean((ours == theirs).all(1))
    print(f"{name:32} {'agrees' if well else 'DISAGREES'}: {exact:.2f} % equal, {len(differ) - len(bad)} edge pixels, {len(bad)} bad, {time.time() - start:.1f} s", flush=True)
    for pixel in bad[:SHOWN]:
        k = np.flatnonzero(differ == pixel)[0]
        print(f"    pixel {pixel % view.width} {pixel // view.width}: lancer {theirs[pixel]}, naive {ours[pixel]}, spans {low[k]} .. {high[k]}")
    return well


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    only = sys.argv[2:]
    with tempfile.TemporaryDirectory() as folder:
        chosen = [row for row in SCENES if not only or row[0] in only]
        results = [compare(sys.argv[1], *row, folder) for row in chosen]
    print(f"{sum(results)} of {len(results)} scenes agree")
    sys.exit(0 if results and all(results) else 1)


if __name__ == "__main__":
    main()
