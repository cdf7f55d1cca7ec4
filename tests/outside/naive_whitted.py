#!/usr/bin/env python3
"""A second, naive Whitted ray tracer: SPEC section 1 in numpy, f64 throughout, by other hands than lancer's.

    python3 naive_whitted.py SCENE VIEW OUT.ppm [--size WxH] [--view NAME] [--samples N] [--depth N] [--without STEPS]

It is an oracle, not a program to use: no hierarchy, no f32, no cleverness. Rays are traced in batches; every function
below takes arrays with one row per ray. The formulas stand in the comments as the specification writes them.
"""
import argparse
import os

for variable in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

import numpy as np

from document import read_scene, read_view
from shapes import NEIGHBOUR, dot, shape, unit

BATCH = 1 << 15


class Stacks:
    """Stacks of media, numbered. An entry is (object, material); the top, or the world, is the medium a ray travels in."""

    def __init__(self, world_index, material_index):
        self.world, self.material_index = world_index, material_index
        self.tuples, self.numbers = [], {}

    def number(self, stack):
        if stack not in self.numbers:
            self.numbers[stack] = len(self.tuples)
            self.tuples.append(stack)
        return self.numbers[stack]

    def index(self, numbers):
        """The index, per channel, of the medium at the top of each stack."""
        tops = [self.material_index[s[-1][1]] if s else self.world for s in self.tuples]
        return np.array(tops)[numbers]

    def cross(self, numbers, objects, materials, entering):
        """Entering pushes (again, if it is there already), leaving removes its last entry; what is not there changes nothing."""
        rows = np.stack([numbers, objects, materials, entering.astype(int)], 1)
        unique, where = np.unique(rows, axis=0, return_inverse=True)
        after = []
        for number, thing, material, enters in unique.tolist():
            stack = self.tuples[number]
            if enters:
                stack = stack + ((thing, material),)
            else:
                at = [i for i, entry in enumerate(stack) if entry[0] == thing]
                if at:
                    stack = stack[:at[-1]] + stack[at[-1] + 1:]
            after.append(self.number(stack))
        return np.array(after, int)[where.reshape(-1)]


class Tracer:
    def __init__(self, scene, depth=None, without=()):
        self.world, self.lights = scene.world, scene.lights
        self.depth = scene.world.depth if depth is None else depth
        self.shadows = "shadows" not in without
        self.reflection = "reflection" not in without
        self.transparency = "transparency" not in without
        self.shapes = [shape(thing) for thing in scene.objects]
        rows = {key: np.array([getattr(m, key) for m in scene.materials]) for key in ("ka", "kd", "ks", "n", "kr", "kt", "index", "w", "highlight")}
        self.material = rows
        self.stacks = Stacks(scene.world.index, rows["index"])
        self.rays = 0

    def eye_stack(self, eye):
        """An eye inside transparent objects starts with them on the stack, outermost first: planes, then by the diagonal of the bounding box."""
        inside = []
        for i, s in enumerate(self.shapes):
            clear = [m for m in s.materials if np.any(self.material["kt"][m] > 0)]
            if clear and s.closed and s.contains(eye):
                inside.append((-s.diagonal, i, int(clear[0])))
        return self.stacks.number(tuple((i, m) for _, i, m in sorted(inside)))

    def nearest(self, S, I, start, start_facet, far=None):
        """The nearest hit: t (infinity: none), object, facet. Equal t: document order, then facet order."""
        self.rays += len(S)
        best = np.full(len(S), np.inf) if far is None else far.copy()
        thing, facet = np.full(len(S), -1), np.full(len(S), -1)
        for i, s in enumerate(self.shapes):
            t, f = s.hits(S, I, np.where(start == i, start_facet, -1), best)
            closer = t < best
            best[closer], thing[closer], facet[closer] = t[closer], i, f[closer]
        return best, thing, facet

    def trace(self, S, I, start, start_facet, stack, want, level):
        """The colours seen along rays. `want`: the channels of each ray whose result counts; the others hold anything in 0..1."""
        colour = np.tile(self.world.background, (len(S), 1))
        if len(S) == 0:
            return colour
        t, thing, facet = self.nearest(S, I, start, start_facet)
        hit = thing >= 0
        if not hit.any():
            return colour
        S, I, t, thing, facet, stack, want = S[hit], I[hit], t[hit], thing[hit], facet[hit], stack[hit], want[hit]
        P = S + t[:, None] * I
        Ng, Ns, closed = np.zeros_like(P), np.zeros_like(P), np.zeros(len(P), bool)
        kind = np.zeros(len(P), int)
        for i in np.unique(thing):
            rows = thing == i
            Ng[rows], Ns[rows] = self.shapes[i].normals(P[rows], facet[rows])
            closed[rows] = self.shapes[i].closed
            kind[rows] = self.shapes[i].materials[facet[rows]]
        entering = dot(I, Ng) < 0
        turn = np.where(entering, 1.0, -1.0)[:, None]       # N is turned against I; the geometric normal decides
        Ng, Ns = turn * Ng, turn * Ns
        m = {key: rows[kind] for key, rows in self.material.items()}

        terms = [m["ka"] * self.world.ambient]              # Ka Ia
        if level < self.depth:
            Ir, It = self.secondary(P, I, Ng, Ns, thing, facet, kind, closed, entering, stack, want, level, m)
            terms += [m["kr"] * Ir, m["kt"] * It]           # Kr Ir, Kt It
        for light in self.lights:
            terms += self.lamp(light, P, I, Ng, Ns, thing, facet, m)
        total = np.zeros_like(P)
        for term in terms:
            if self.world.compose == "add":
                total = total + term                        # clamped once, below
            else:
                term = np.clip(term, 0, 1)
                total = total + term * (1 - total)          # a (+) b = a + b (1 - a)
        colour[hit] = np.clip(total, 0, 1)
        return colour

    def lamp(self, light, P, I, Ng, Ns, thing, facet, m):
        """(Kd cos l + W(l) cos^n s) I_L, if no object meets the open segment from the point to the lamp."""
        way = light.position - P
        distance = np.sqrt(dot(way, way))
        L = way / np.where(distance > 0, distance, 1)[:, None]      # a lamp at the point itself gives nothing: L = 0
        cos_l = dot(Ns, L)
        least = NEIGHBOUR * np.maximum(np.abs(P).max(1), np.abs(light.position).max())
        lit = np.flatnonzero((cos_l > 0) & (dot(Ng, way) > least))  # a lamp in the surface's own plane is not in front of it
        if self.shadows and len(lit):
            near = distance[lit] * (1 - NEIGHBOUR)                   # nor hidden by the surface that it lies on
            _, blocker, _ = self.nearest(P[lit], L[lit], thing[lit], facet[lit], far=near)
            lit = lit[blocker < 0]
        diffuse, highlight = np.zeros_like(P), np.zeros_like(P)
        if len(lit):
            k = {key: rows[lit] for key, rows in m.items()}
            N, L, V, c = Ns[lit], L[lit], -I[lit], cos_l[lit][:, None]
            mirrored = 2 * c * N - L                                 # R_L = 2 (N.L) N - L
            half = L + V                                             # H = unit(L + V)
            half = half / np.maximum(np.sqrt(dot(half, half)), 1e-300)[:, None]
            cos_s = np.where(k["highlight"] == "blinn", dot(N, half), dot(mirrored, V))[:, None]
            law = k["w"][:, None]
            W = np.where(law == "schlick", k["ks"] + (1 - k["ks"]) * np.maximum(1 - c, 0) ** 5,
                         np.where(law == "grazing", k["ks"] * np.maximum(1 - c, 0), k["ks"]))
            power = np.where(cos_s > 0, np.clip(cos_s, 1e-300, 1) ** k["n"], 0)     # cos s = 0: no highlight, whatever n
            diffuse[lit] = k["kd"] * c * light.color
            highlight[lit] = W * power * light.color
        if self.world.compose == "screen-each":
            return [diffuse, highlight]
        return [diffuse + highlight]

    def secondary(self, P, I, Ng, Ns, thing, facet, kind, closed, entering, stack, want, level, m):
        """Ir and It: the light seen along the mirrored ray R and along the refracted rays T."""
        Ir, It = np.zeros_like(P), np.zeros_like(P)
        mirror = want & (m["kr"] > 0) if self.reflection else np.zeros_like(want)
        glass = want & (m["kt"] > 0) if self.transparency else np.zeros_like(want)
        after, n, n_ = stack.copy(), np.ones_like(P), np.ones_like(P)
        some = np.flatnonzero(glass.any(1) & closed)             # a sheet: n = n' = 1, straight on, the stack stays
        if len(some):
            after[some] = self.stacks.cross(stack[some], thing[some], kind[some], entering[some])
            n[some], n_[some] = self.stacks.index(stack[some]), self.stacks.index(after[some])
        cos = dot(I, Ng)[:, None]
        root = (n_ / n) ** 2 + cos ** 2 - 1
        root = np.where(n == n_, cos ** 2, root)
        total = glass & (root < 0)                               # total internal reflection: It is the light seen along R

        rows = np.flatnonzero((mirror | total).any(1))
        if len(rows):
            i, N, G = I[rows], Ns[rows], Ng[rows]
            R = unit(i - 2 * dot(i, N)[:, None] * N)             # R = I - 2 (I.N) N
            inward = np.minimum(dot(R, G), 0)[:, None]
            R = R - 2 * inward * G                               # an R that would enter the surface is mirrored out of it
            seen = self.trace(P[rows], R, thing[rows], facet[rows], stack[rows], (mirror | total)[rows], level + 1)
            Ir[rows] = np.where(mirror[rows], seen, 0)
            It[rows] = np.where(total[rows], seen, 0)

        through, ratio = glass & ~total, n / n_
        for c in range(3):                                       # channels of equal n/n' share a ray; the first of them leads
            shares = through & through[:, c:c + 1] & (ratio == ratio[:, c:c + 1])
            rows = np.flatnonzero(through[:, c] & ~shares[:, :c].any(1))
            if len(rows):
                i, G, k, x = I[rows], Ng[rows], ratio[rows, c:c + 1], cos[rows]
                T = unit(k * (i - (x + np.sqrt(root[rows, c:c + 1])) * G))     # T = (n/n') (I - ((I.N) + sqrt((n'/n)2 + (I.N)2 - 1)) N)
                seen = self.trace(P[rows], T, thing[rows], facet[rows], after[rows], shares[rows], level + 1)
                It[rows] = np.where(shares[rows], seen, It[rows])
        return Ir, It

    def look(self, view, x, y):
        """The colours at screen positions x, y, counted in pixels from the top left corner."""
        stack = self.eye_stack(view.eye)
        out = []
        for first in range(0, len(x), BATCH):
            part = slice(first, first + BATCH)
            on = view.origin + (x[part] / view.width)[:, None] * view.u + (y[part] / view.height)[:, None] * view.v
            n = len(on)
            out.append(self.trace(np.tile(view.eye, (n, 1)), unit(on - view.eye), np.full(n, -1), np.full(n, -1),
                                  np.full(n, stack), np.ones((n, 3), bool), 0))
        return np.concatenate(out)


def centres(view):
    """The k x k sample positions of every pixel, k x k rows of width * height."""
    j, i = np.divmod(np.arange(view.width * view.height), view.width)
    k = view.samples
    return [(i + (s + 0.5) / k, j + (r + 0.5) / k) for r in range(k) for s in range(k)]


def byte(colour):
    return np.floor(255 * np.clip(colour, 0, 1) + 0.5).astype(int)


def render(tracer, view):
    """-> height x width x 3 bytes: the mean of each pixel's samples, every one clamped."""
    total = sum(tracer.look(view, x, y) for x, y in centres(view))
    return byte(total / view.samples ** 2).reshape(view.height, view.width, 3)


def write_ppm(path, picture):
    with open(path, "w", encoding="ascii") as file:
        height, width, _ = picture.shape
        file.write(f"P3\n# lancer\n{width} {height}\n255\n")
        for row in picture:
            words = [" ".join(map(str, pixel)) for pixel in row]
            for first in range(0, width, 5):
                file.write(" ".join(words[first:first + 5]) + "\n")


def main():
    parser = argparse.ArgumentParser(description="a second, naive Whitted ray tracer")
    parser.add_argument("scene")
    parser.add_argument("view")
    parser.add_argument("out")
    parser.add_argument("--size", help="WxH, instead of the view's")
    parser.add_argument("--view", dest="wanted", help="the view of this name, not the first")
    parser.add_argument("--samples", type=int)
    parser.add_argument("--depth", type=int)
    parser.add_argument("--without", help='"shadows reflection transparency"')
    given = parser.parse_args()
    size = tuple(map(int, given.size.lower().split("x"))) if given.size else None
    view = read_view(given.view, given.wanted, size)
    view.samples = given.samples or view.samples
    depth = given.depth if given.depth is not None else view.depth
    without = given.without.split() if given.without is not None else view.without
    tracer = Tracer(read_scene(given.scene), depth, without)
    write_ppm(given.out, render(tracer, view))
    print(f"{given.out}: {view.width} x {view.height}, {tracer.rays} rays")


if __name__ == "__main__":
    main()
