"""Where rays meet objects: the sphere, the plane, and the object made of facets (SPEC section 1; the subject's section 3).

A ray is a point S and a unit direction I; rays come as arrays of n rows. A shape answers, for every ray, the distance of
its nearest hit (infinity: none) and the facet that is hit. `start` is the facet of this shape that the ray starts on, or -1:
that very surface is left out, and nothing else.
"""
import numpy as np

NONE = np.inf
CRACK = 1e-12       # facets grow by this share of themselves, so that rounding opens no crack between two of them
NEIGHBOUR = 1e-9    # a ray from one facet meets no other facet of its object nearer than this share of the coordinates
TOUCH = 1e-12       # what a ray starts on, as far as rounding lets one tell, is no hit either: an eye may lie on a surface


def dot(a, b):
    return np.einsum("...i,...i->...", a, b)


def unit(rows):
    return rows / np.sqrt(dot(rows, rows))[..., None]


def touch(S, Q):
    """How near is on it, for points S and a point Q of the surface."""
    return TOUCH * np.maximum(np.abs(S).max(-1), np.abs(Q).max())


class Sphere:
    closed = True

    def __init__(self, thing):
        self.center, self.radius, self.materials = thing.center, thing.radius, np.array([thing.material])
        self.diagonal = 2 * np.sqrt(3) * thing.radius

    def hits(self, S, I, start, far):
        """q = I.SC; Delta = r2 + q2 - |SC|2, computed as r2 - |SC - q I|2; t = q -/+ sqrt(Delta).
        From a point of the sphere itself the two are 0, which is left out, and 2q."""
        SC = self.center - S
        q = dot(I, SC)
        delta = self.radius ** 2 - dot(SC - q[:, None] * I, SC - q[:, None] * I)
        root = np.sqrt(np.maximum(delta, 0))
        t = np.where(q - root > 0, q - root, q + root)
        on = np.abs(np.sqrt(dot(SC, SC)) - self.radius) <= touch(S, self.center) + TOUCH * self.radius
        t = np.where((start >= 0) | on, 2 * q, np.where(delta > 0, t, NONE))
        return np.where(t > 0, t, NONE), np.zeros(len(S), int)

    def normals(self, P, facet):
        N = unit(P - self.center)
        return N, N

    def contains(self, P):
        return np.linalg.norm(P - self.center) < self.radius - touch(P, self.center) - TOUCH * self.radius


class Plane:
    closed = True       # it bounds the half-space behind its normal
    diagonal = np.inf   # outermost of all

    def __init__(self, thing):
        self.p0, self.materials = thing.p0, np.array([thing.material])
        self.normal = unit(np.cross(thing.p1 - thing.p0, thing.p2 - thing.p0))     # P0P1 x P0P2

    def hits(self, S, I, start, far):
        with np.errstate(divide="ignore", invalid="ignore"):
            height = (self.p0 - S) @ self.normal
            t = height / (I @ self.normal)
        return np.where((t > 0) & (start < 0) & (np.abs(height) > touch(S, self.p0)), t, NONE), np.zeros(len(S), int)

    def normals(self, P, facet):
        N = np.broadcast_to(self.normal, P.shape)
        return N, N

    def contains(self, P):
        return (P - self.p0) @ self.normal < -touch(P, self.p0)


class Cone:
    """The side by its equation in a frame of its own, x2 + y2 = (r + m z)2 for 0 <= z <= h, and the discs at its ends."""

    def __init__(self, thing):
        self.h = np.linalg.norm(thing.top - thing.base)
        z = (thing.top - thing.base) / self.h
        x = unit(np.cross(z, np.eye(3)[np.argmin(np.abs(z))]))
        self.frame, self.base = np.array([x, np.cross(z, x), z]), thing.base
        self.r, self.R, self.closed = thing.base_radius, thing.top_radius, thing.capped
        self.m = (self.R - self.r) / self.h
        self.materials = np.array([thing.material] * 3)
        if self.r == self.R == 0 or self.h == 0:
            raise ValueError("a flat cone")
        reach = np.sqrt(np.maximum(0, 1 - z * z))
        low = np.minimum(thing.base - reach * self.r, thing.top - reach * self.R)
        high = np.maximum(thing.base + reach * self.r, thing.top + reach * self.R)
        self.diagonal = np.linalg.norm(high - low)

    def hits(self, S, I, start, far):
        s, i = (S - self.base) @ self.frame.T, I @ self.frame.T
        with np.errstate(divide="ignore", invalid="ignore"):
            w, dw = self.r + self.m * s[:, 2], self.m * i[:, 2]
            a = i[:, 0] ** 2 + i[:, 1] ** 2 - dw ** 2
            b = s[:, 0] * i[:, 0] + s[:, 1] * i[:, 1] - w * dw
            c = s[:, 0] ** 2 + s[:, 1] ** 2 - w ** 2
            root = np.sqrt(np.where(np.abs(b * b - a * c) < 1e-12 * b * b, 0, b * b - a * c))
            ts = [(-b - root) / a, (-b + root) / a] + [(h - s[:, 2]) / i[:, 2] for h in (0, self.h)]
            least = np.where(start >= 0, NEIGHBOUR, TOUCH) * (1 + np.abs(S).max(1))
            best, which = np.full(len(S), NONE), np.zeros(len(S), int)
            for k, t in enumerate(ts):
                p = s + t[:, None] * i
                if k < 2:
                    good, face = (p[:, 2] >= -1e-12) & (p[:, 2] <= self.h + 1e-12) & (root >= 0), 0
                    good &= (root > 0) | (np.abs(i[:, 2]) == 1)     # a touching ray is no hit, one down the axis is
                else:
                    good, face = (p[:, 0] ** 2 + p[:, 1] ** 2 < (self.r, self.R)[k - 2] ** 2) & self.closed, k - 1
                good &= (t > least) & (t < best)
                best, which = np.where(good, t, best), np.where(good, face, which)
        return best, which

    def normals(self, P, facet):
        p = (P - self.base) @ self.frame.T
        around = np.hypot(p[:, 0], p[:, 1])[:, None]
        with np.errstate(divide="ignore", invalid="ignore"):
            side = np.where(around > 1e-15, np.c_[p[:, :2] / around, np.full(len(p), -self.m)], [0, 0, -np.sign(self.m)])
        N = unit(np.where(facet[:, None] == 0, side, np.where(facet[:, None] == 1, [0, 0, -1.0], [0, 0, 1.0])))
        return N @ self.frame, N @ self.frame

    def contains(self, P):
        p, near = (P - self.base) @ self.frame.T, touch(P, self.base)
        within = near < p[2] < self.h - near and np.hypot(p[0], p[1]) < self.r + self.m * p[2] - near
        return self.closed and bool(within)


class Facets:
    """An object made of facets. A facet is hit where alpha >= 0, beta >= 0, alpha + beta <= 1."""

    def __init__(self, vertices, facets, materials, smooth=False):
        merged, same = np.unique(vertices, axis=0, return_inverse=True)
        facets = same.reshape(-1)[facets]
        p0, p1, p2 = (merged[facets[:, i]] for i in range(3))
        area = np.linalg.norm(np.cross(p1 - p0, p2 - p0), axis=1)
        keep = area > 1e-15 * np.maximum(1e-300, dot(p1 - p0, p1 - p0) + dot(p2 - p0, p2 - p0))
        facets, self.materials = facets[keep], np.asarray(materials)[keep]
        self.closed = self.is_closed(facets)
        p0, p1, p2 = (merged[facets[:, i]] for i in range(3))
        if self.closed and np.sum(dot(p0 - merged[0], np.cross(p1 - merged[0], p2 - merged[0]))) < 0:
            facets, p1, p2 = facets[:, [0, 2, 1]], p2, p1      # outwards by its signed volume
        self.corners = np.stack([p0, p1, p2], 1)
        e1, e2 = p1 - p0, p2 - p0
        cross = np.cross(e1, e2)
        self.normal = unit(cross)                               # P0P1 x P0P2
        square = dot(cross, cross)[:, None]
        self.a = np.cross(e2, cross) / square                   # alpha = a.(P - P0), beta = b.(P - P0)
        self.b = np.cross(cross, e1) / square
        self.p0 = p0
        self.diagonal = np.linalg.norm(np.ptp(self.corners.reshape(-1, 3), axis=0))
        self.smooth = None
        if smooth:                                              # area-weighted over merged positions
            at = np.zeros_like(merged)
            for i in range(3):
                np.add.at(at, facets[:, i], cross)
            self.smooth = at[facets] / np.maximum(1e-300, np.linalg.norm(at[facets], axis=2, keepdims=True))
        self.groups = []
        self.split(np.arange(len(facets)))

    @staticmethod
    def is_closed(facets):
        """Every edge has exactly two facets, in opposite directions."""
        edges = [tuple(edge) for f in facets for edge in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0]))]
        once = set(edges)
        return len(edges) > 0 and len(once) == len(edges) and all((b, a) in once for a, b in once)

    def split(self, group):
        """Groups of near facets with their boxes: only to pass over the rays that miss the whole group."""
        boxes = self.corners[group]
        low, high = boxes.min((0, 1)), boxes.max((0, 1))
        if len(group) > 24:
            middle = boxes.mean(1)[:, np.argmax(high - low)]
            order = np.argsort(middle, kind="stable")
            self.split(np.sort(group[order[:len(group) // 2]]))
            self.split(np.sort(group[order[len(group) // 2:]]))
        else:
            pad = 1e-9 * (1 + np.abs(low) + np.abs(high))
            self.groups.append((group, low - pad, high + pad))

    def hits(self, S, I, start, far):
        best, which = far.copy(), np.full(len(S), -1)
        with np.errstate(divide="ignore", invalid="ignore"):
            inverse = 1 / I
            for group, low, high in self.groups:
                t0, t1 = (low - S) * inverse, (high - S) * inverse
                near, away = np.fmax.reduce(np.fmin(t0, t1), axis=1), np.fmin.reduce(np.fmax(t0, t1), axis=1)
                some = np.flatnonzero((near <= away) & (away >= 0) & (near <= best))
                if len(some) == 0:
                    continue
                p0, n, a, b = self.p0[group], self.normal[group], self.a[group], self.b[group]
                s, i = S[some], I[some]
                t = (dot(p0, n) - s @ n.T) / (i @ n.T)          # gamma; parallel: not finite, no hit
                alpha = s @ a.T + t * (i @ a.T) - dot(p0, a)
                beta = s @ b.T + t * (i @ b.T) - dot(p0, b)
                own = start[some, None]
                least = np.where(own >= 0, NEIGHBOUR, TOUCH) * (1 + np.abs(s).max(1))[:, None]
                good = (alpha >= -CRACK) & (beta >= -CRACK) & (alpha + beta <= 1 + CRACK) & (t > least) & (own != group)
                t = np.where(good, t, NONE)
                k = t.argmin(1)
                t, k = t[np.arange(len(some)), k], group[k]
                better = (t < best[some]) | ((t == best[some]) & (t < NONE) & (which[some] >= 0) & (k < which[some]))
                best[some[better]], which[some[better]] = t[better], k[better]
        return np.where(which >= 0, best, NONE), which

    def normals(self, P, facet):
        """The geometric normal and the one to shade with."""
        N = self.normal[facet]
        if self.smooth is None:
            return N, N
        alpha = dot(self.a[facet], P - self.p0[facet])[:, None]
        beta = dot(self.b[facet], P - self.p0[facet])[:, None]
        corner = self.smooth[facet]
        M = (1 - alpha - beta) * corner[:, 0] + alpha * corner[:, 1] + beta * corner[:, 2]
        size = np.sqrt(dot(M, M))[:, None]
        return N, np.where(size > 1e-12, M / np.maximum(size, 1e-300), N)

    def contains(self, P):
        """By the solid angle of all facets: 4 pi within, 0 outside; a point on a facet is outside."""
        if not self.closed:
            return False
        a, b, c = (self.corners[:, i] - P for i in range(3))
        la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
        volume = dot(a, np.cross(b, c))
        base = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
        if np.any((volume == 0) & (base <= 0)):     # arctan2(0, -x) is a half turn: the whole sphere from within the facet
            return False
        return abs(np.sum(2 * np.arctan2(volume, base))) > 3 * np.pi


def rotation(degrees):
    """About the fixed axes x, y, z in turn."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return z @ y @ x


def block(origin, u, v, w, material):
    """The 12 facets of a parallelepiped."""
    if np.dot(np.cross(u, v), w) == 0:
        raise ValueError("a flat box")
    corners = np.array([origin + i * u + j * v + k * w for k in (0, 1) for j in (0, 1) for i in (0, 1)])
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    facets = [f for a, b, c, d in quads for f in ((a, b, c), (a, c, d))]
    return Facets(corners, np.array(facets), np.full(12, material))


def shape(thing):
    """The shape of one object of the document."""
    if thing.kind == "sphere":
        return Sphere(thing)
    if thing.kind in ("plane", "facet"):
        if np.linalg.norm(np.cross(thing.p1 - thing.p0, thing.p2 - thing.p0)) == 0:
            raise ValueError("collinear points")
        if thing.kind == "plane":
            return Plane(thing)
        return Facets(np.array([thing.p0, thing.p1, thing.p2]), np.array([[0, 1, 2]]), [thing.material])
    if thing.kind == "cone":
        return Cone(thing)
    if thing.kind == "cube":
        axes = thing.edge * rotation(thing.rotation).T
        return block(thing.center - axes.sum(0) / 2, *axes, thing.material)
    if thing.kind == "box":
        return block(thing.origin, thing.u, thing.v, thing.w, thing.material)
    vertices = (thing.vertices * thing.scale) @ rotation(thing.rotation).T + thing.position
    return Facets(vertices, thing.facets, thing.materials, thing.smooth)
