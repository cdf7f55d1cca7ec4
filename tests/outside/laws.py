#!/usr/bin/env python3
"""The naive implementation against the numbers of SPEC section 1, "law tests that cost one line each": python3 laws.py"""
import os
import tempfile

import naive_whitted as naive
import numpy as np
from document import read_scene

MIRRORS = """<world ambient="1" depth="60" background="0"/><material name="m" ka="0.4" kd="0" kr="0.5"/>
  <plane p0="0 0 0" p1="1 0 0" p2="0 1 0" material="m"/><plane p0="0 0 1" p1="1 0 1" p2="0 1 1" material="m"/>"""
WATER = """<world depth="3"/><material name="g" kt="1" index="1.5"/><plane p0="0 0 0" p1="0 0 1" p2="1 0 0" material="g"/>"""
NESTED = """<world depth="12"/><material name="a" kt="1" index="1.5"/><material name="b" kt="1" index="2"/>
  <material name="c" kt="1" index="2.5"/><sphere center="0 0 0" radius="10" material="a"/>
  <sphere center="0 0 -1" radius="2" material="b"/><sphere center="0 0 1" radius="2" material="c"/>"""


class Watched(naive.Tracer):
    """A tracer that keeps every ray it casts: level, direction, and the index of its medium."""

    def __init__(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".xml", delete=False) as file:
            file.write(f'<scene version="1">{text}</scene>')
        super().__init__(read_scene(file.name))
        os.remove(file.name)
        self.cast = []

    def trace(self, S, I, start, start_facet, stack, want, level):
        self.cast += [(level, d, n) for d, n in zip(I, self.stacks.index(stack)[:, 0])]
        return super().trace(S, I, start, start_facet, stack, want, level)

    def look_from(self, eye, way):
        eye, none = np.array([eye], float), np.array([-1])
        way = np.array([way], float)
        return self.trace(eye, naive.unit(way), none, none, np.array([self.eye_stack(eye[0])]), np.ones((1, 3), bool), 0)[0]


def near(what, got, wanted, tolerance=1e-7):
    assert np.allclose(got, wanted, rtol=0, atol=tolerance), f"{what}: {got}, not {wanted}"
    print(f"{what}: {np.round(got, 7)}")


def refracted(degrees, up=False):
    """The angle to the normal of the ray beyond the surface y = 0; 180 - angle if it is thrown back."""
    tracer = Watched(WATER)
    a = np.radians(degrees)
    tracer.look_from([0, -1 if up else 1, 0], [np.sin(a), np.cos(a) if up else -np.cos(a), 0])
    way = tracer.cast[1][1]
    return np.degrees(np.arccos(way[1] if up else -way[1]))


near("1 -> 1.5 at 30 degrees", refracted(30), 19.4712206)
near("1 -> 1.5 at 60 degrees", refracted(60), 35.2643897)
assert refracted(41.8103148, up=True) < 90 < refracted(41.8103150, up=True), "the critical angle of 1.5"
print("the critical angle of 1.5: between 41.8103148 and 41.8103150")
near("two facing mirrors", Watched(MIRRORS).look_from([0, 0, 0.5], [0, 0, 1]), 0.4 / (1 - (1 - 0.4) * 0.5))
nested = Watched(NESTED)
nested.look_from([0, 0, -20], [0, 0, 1])
near("nested glass", [n for _, _, n in nested.cast], [1, 1.5, 2, 2.5, 2.5, 1.5, 1])
within = Watched(NESTED)
within.look_from([0, 0, 0], [0, 0, 1])
near("an eye within nested glass", [n for _, _, n in within.cast], [2.5, 2.5, 1.5, 1])
