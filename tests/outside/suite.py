#!/usr/bin/env python3
"""Does the naive implementation agree with the pictures of the scene suite?

    python3 suite.py [TOPIC/NAME ...]

Every tests/scenes/<topic>/<one-thing>.ppm is compared with what the naive implementation makes of its scene and view, by
the rule of agrees.py: one level of 255, but for edge pixels. No lancer is needed: the pictures are what it is held to.
Documents of 2009 and meshes from files are not read here. Prints a line for each disagreement; exit code 1 if there is one.
"""
import glob
import os
import sys

import naive_whitted as naive
import numpy as np
from agrees import read_ppm, span
from document import read_scene, read_view

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes")
UNREAD = (b"<Scene>", b"src=")


def disagreement(stem):
    """What is wrong with a picture, or nothing."""
    view = read_view(stem + ".view.xml")
    tracer = naive.Tracer(read_scene(stem + ".xml"), view.depth, view.without)
    ours, theirs = naive.render(tracer, view), read_ppm(stem + ".ppm")
    if ours.shape != theirs.shape:
        return f"the picture is {theirs.shape}, not {ours.shape}"
    ours, theirs = ours.reshape(-1, 3), theirs.reshape(-1, 3)
    differ = np.flatnonzero((np.abs(ours - theirs) > 1).any(1))
    if len(differ) == 0:
        return None
    low, high = span(tracer, view, differ)
    bad = differ[((theirs[differ] < low - 1) | (theirs[differ] > high + 1)).any(1)]
    if len(bad) == 0:
        return None
    places = [f"{p % view.width} {p // view.width}: {theirs[p]}, naive {ours[p]}" for p in bad[:5]]
    return f"{len(bad)} pixels, " + "; ".join(places)


def main():
    found = sorted(os.path.relpath(path[:-4], ROOT) for path in glob.glob(os.path.join(ROOT, "*", "*.ppm")))
    names = [name for name in found if not sys.argv[1:] or name in sys.argv[1:]]
    compared = wrong = 0
    for name in names:
        stem = os.path.join(ROOT, name)
        # naive reads the native documents alone
        if not os.path.exists(stem + ".xml"):
            continue
        with open(stem + ".xml", "rb") as file:
            text = file.read()
        if any(mark in text for mark in UNREAD):
            continue
        compared += 1
        said = disagreement(stem)
        if said:
            wrong += 1
            print(f"{name}: {said}", flush=True)
    print(f"{compared - wrong} of {compared} pictures agree")
    sys.exit(0 if compared and not wrong else 1)


if __name__ == "__main__":
    main()
