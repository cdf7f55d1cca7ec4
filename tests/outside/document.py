"""The native scene and view documents (SPEC sections 2 and 3), read strictly into plain Python values.

Second implementation, written from the specification alone; the scene and view crates were not looked at.
An unknown element or attribute, a name used twice, a value out of range: ValueError, with what was wrong.
`mesh@src` is not read here.
"""
import re
import xml.etree.ElementTree as ET
from types import SimpleNamespace as Record

import numpy as np

NUMBER = re.compile(r"[+-]?\d+(\.\d+)?([eE][+-]?\d+)?$")
REQUIRED = object()


def numbers(text):
    """Numbers separated by white space or one comma with white space around it."""
    words = re.split(r"\s*,\s*|\s+", text.strip())
    for word in words:
        if not NUMBER.match(word):
            raise ValueError(f"not a number: {word!r} in {text!r}")
    return np.array([float(word) for word in words])


def count(text, *counts):
    values = numbers(text)
    if len(values) not in counts:
        raise ValueError(f"{len(values)} numbers in {text!r}, expected {counts}")
    return values


def within(low, high, values):
    if not (np.all(np.asarray(values) >= low) and np.all(np.asarray(values) <= high)):
        raise ValueError(f"{values} outside {low}..{high}")
    return values


def one(text):
    return float(count(text, 1)[0])


def integer(low, high):
    def read(text):
        if not re.match(r"[+-]?\d+$", text.strip()):
            raise ValueError(f"not an integer: {text!r}")
        return within(low, high, int(text))
    return read


def length(text):
    return within(1e-9, 1e9, one(text))


def point(text):
    return within(-1e9, 1e9, count(text, 3))


def three(low, high):
    """One number stands for three equal ones."""
    return lambda text: within(low, high, np.broadcast_to(count(text, 1, 3), 3).copy())


def color(text):
    if re.match(r"#[0-9a-fA-F]{6}$", text.strip()):
        return np.array([int(text.strip()[i:i + 2], 16) / 255 for i in (1, 3, 5)])
    return three(0, 1)(text)


def choice(*legal):
    def read(text):
        if text.strip() not in legal:
            raise ValueError(f"{text!r} is none of {legal}")
        return text.strip()
    return read


def name(text):
    if not text.strip():
        raise ValueError("an empty name")
    return text.strip()


def truth(text):
    return choice("true", "false")(text) == "true"


def scale(text):
    values = three(-1e9, 1e9)(text)
    if not np.all(values):
        raise ValueError("scale 0")
    return values


def radius(text):
    value = one(text)
    if not 0 <= value <= 1e9:
        raise ValueError("a radius")
    return value


ZERO, ONE = np.zeros(3), np.ones(3)
NAMED = {"name": (name, None), "visible": (truth, True)}
OBJECT = {**NAMED, "material": (name, None)}
INDEX = three(1e-300, 1e300)
# element -> attribute -> (reader, default)
TABLE = {
    "scene": {"version": (integer(1, 1), REQUIRED), "name": (str, "")},
    "world": {"ambient": (color, 0.2 * ONE), "background": (color, ZERO), "index": (INDEX, ONE),
              "depth": (integer(0, 64), 6), "compose": (choice("screen", "screen-each", "add"), "screen")},
    "light": {**NAMED, "position": (point, REQUIRED), "color": (color, ONE)},
    "material": {"name": (name, None), "ka": (color, 0.2 * ONE), "kd": (color, 0.6 * ONE), "ks": (color, ZERO),
                 "w": (choice("constant", "schlick", "grazing"), "constant"), "n": (three(0, 10000), 30 * ONE),
                 "kr": (color, ZERO), "kt": (color, ZERO), "index": (INDEX, ONE),
                 "highlight": (choice("phong", "blinn"), "phong")},
    "sphere": {**OBJECT, "center": (point, REQUIRED), "radius": (length, REQUIRED)},
    "plane": {**OBJECT, "p0": (point, REQUIRED), "p1": (point, REQUIRED), "p2": (point, REQUIRED)},
    "facet": {**OBJECT, "p0": (point, REQUIRED), "p1": (point, REQUIRED), "p2": (point, REQUIRED)},
    "cube": {**OBJECT, "center": (point, REQUIRED), "edge": (length, REQUIRED), "rotation": (point, ZERO)},
    "box": {**OBJECT, "origin": (point, REQUIRED), "u": (point, REQUIRED), "v": (point, REQUIRED), "w": (point, REQUIRED)},
    "cone": {**OBJECT, "base": (point, REQUIRED), "top": (point, REQUIRED), "base-radius": (radius, REQUIRED),
             "top-radius": (radius, REQUIRED), "capped": (truth, True)},
    "mesh": {**OBJECT, "position": (point, ZERO), "rotation": (point, ZERO), "scale": (scale, ONE), "smooth": (truth, False)},
    "part": {"material": (name, REQUIRED), "facets": (lambda text: count(text, 2).astype(int), REQUIRED)},
    "vertices": {}, "facets": {},
    "views": {"version": (integer(1, 1), REQUIRED)},
    "view": {"version": (integer(1, 1), 1), "name": (name, None), "width": (integer(1, 65535), 640),
             "height": (integer(1, 65535), 480), "samples": (integer(1, 64), 1), "depth": (integer(0, 64), None),
             "without": (str.split, [])},
    "eye": {"at": (point, REQUIRED), "look-at": (point, None), "up": (point, None), "fov": (one, 45.0)},
    "screen": {"origin": (point, None), "u": (point, None), "v": (point, None), "center": (point, None),
               "size": (lambda text: count(text, 2), None), "up": (point, None), "corners": (lambda text: count(text, 12), None)},
}


def attributes(node):
    """The attributes of a node by TABLE, as a Record; `-` becomes `_` in their names."""
    table, got = TABLE[node.tag], {}
    for key in node.attrib:
        if key not in table:
            raise ValueError(f"unknown attribute {node.tag}@{key}")
    for key, (read, default) in table.items():
        if key in node.attrib:
            try:
                got[key.replace("-", "_")] = read(node.attrib[key])
            except ValueError as error:
                raise ValueError(f"{node.tag}@{key}: {error}") from None
        elif default is REQUIRED:
            raise ValueError(f"{node.tag}@{key} is required")
        else:
            got[key.replace("-", "_")] = default
    return Record(kind=node.tag, **got)


def children(node, *legal):
    for child in node:
        if child.tag not in legal:
            raise ValueError(f"<{child.tag}> within <{node.tag}>")
        if (child.tail or "").strip():
            raise ValueError(f"text within <{node.tag}>: {child.tail.strip()!r}")
    if node.tag not in ("vertices", "facets") and (node.text or "").strip():
        raise ValueError(f"text within <{node.tag}>: {node.text.strip()!r}")
    return list(node)


def read_scene(path):
    """-> Record(world, materials: list, lights: list, objects: list); objects hold material *numbers*; the invisible are left out."""
    root = ET.parse(path).getroot()
    if root.tag != "scene":
        raise ValueError(f"root <{root.tag}>")
    shapes = ("sphere", "plane", "facet", "cube", "box", "cone", "mesh")
    nodes = children(root, "world", "material", "light", *shapes)
    attributes(root)
    worlds = [node for node in nodes if node.tag == "world"]
    if len(worlds) > 1:
        raise ValueError("a second <world>")
    world = attributes(worlds[0] if worlds else ET.Element("world"))
    materials, number = [attributes(ET.Element("material"))], {}
    for node in nodes:
        if node.tag == "material":
            material = attributes(node)
            if material.name is None or material.name in number:
                raise ValueError(f"material without a name or twice: {material.name}")
            number[material.name] = len(materials)
            materials.append(material)
    names, lights, objects = set(), [], []
    for node in nodes:
        if node.tag in ("world", "material"):
            children(node)
            continue
        thing = attributes(node)
        if thing.name in names:
            raise ValueError(f"the name {thing.name!r} twice")
        if thing.name:
            names.add(thing.name)
        inner = children(node, *(["material"] if node.tag != "light" else []), *(["vertices", "facets", "part"] if node.tag == "mesh" else []))
        if node.tag == "light":
            if thing.visible:
                lights.append(thing)
            continue
        inline = [child for child in inner if child.tag == "material"]
        if len(inline) > 1 or (inline and thing.material):
            raise ValueError(f"two materials on {thing.name!r}")
        if inline:
            materials.append(attributes(inline[0]))
            thing.material = len(materials) - 1
        else:
            thing.material = number[thing.material] if thing.material else 0
        if node.tag == "mesh":
            texts = {child.tag: child.text for child in inner if child.tag in ("vertices", "facets")}
            thing.vertices = within(-1e9, 1e9, numbers(texts["vertices"])).reshape(-1, 3)
            thing.facets = numbers(texts["facets"]).astype(int).reshape(-1, 3)
            within(0, len(thing.vertices) - 1, thing.facets)
            thing.materials = np.full(len(thing.facets), thing.material)
            for child in inner:
                if child.tag == "part":
                    part = attributes(child)
                    first, amount = part.facets
                    within(0, len(thing.facets), [first, first + amount])
                    thing.materials[first:first + amount] = number[part.material]
        if thing.visible:
            objects.append(thing)
    return Record(world=world, materials=materials, lights=lights, objects=objects)


def unit(vector):
    return vector / np.linalg.norm(vector)


def read_view(path, wanted=None, size=None):
    """-> Record(eye, origin, u, v, width, height, samples, depth, without); the first view, or the one called `wanted`."""
    root = ET.parse(path).getroot()
    nodes = [root] if root.tag == "view" else children(root, "view")
    if root.tag != "view":
        attributes(root)
    for node in nodes:
        children(node, "eye", "screen")
    names = [node.get("name").strip() for node in nodes if node.get("name")]
    if len(names) != len(set(names)):
        raise ValueError("two views of one name")
    found = [node for node in nodes if wanted is None or node.get("name") == wanted]
    if not found:
        raise ValueError(f"no view {wanted!r} in {path}")
    view = attributes(found[0])
    if size:
        view.width, view.height = size
    for step in view.without:
        choice("shadows", "reflection", "transparency")(step)
    eye = attributes(found[0].find("eye"))
    screen = found[0].find("screen")
    view.eye = eye.at
    if eye.look_at is not None:
        if screen is not None or np.all(eye.look_at == eye.at):
            raise ValueError("look-at beside a screen, or at the eye")
        within(1, 179, eye.fov)
        d = unit(eye.look_at - eye.at)              # d = unit(look-at - at)
        r = unit(np.cross(d, eye.up if eye.up is not None else [0, 1, 0]))      # r = unit(d x up)
        t = np.cross(r, d)                          # t = r x d
        half = np.tan(np.radians(eye.fov) / 2)
        tall = half * view.height / view.width
        view.origin, view.u, view.v = eye.at + d - half * r + tall * t, 2 * half * r, -2 * tall * t
        return view
    screen = attributes(screen)
    if screen.corners is not None:
        bl, br, tr, tl = screen.corners.reshape(4, 3)
        if np.linalg.norm(bl - br + tr - tl) > 1e-6 * max(np.linalg.norm(tr - tl), np.linalg.norm(bl - tl)):
            raise ValueError("the corners are no parallelogram")
        view.origin, view.u, view.v = tl, tr - tl, bl - tl
    elif screen.center is not None:
        w, h = screen.size
        d = unit(screen.center - eye.at)
        r = unit(np.cross(d, screen.up if screen.up is not None else [0, 1, 0]))
        t = np.cross(r, d)
        view.origin, view.u, view.v = screen.center - w / 2 * r + h / 2 * t, w * r, -h * t
    else:
        view.origin, view.u, view.v = screen.origin, screen.u, screen.v
    if abs(np.dot(np.cross(view.u, view.v), view.eye - view.origin)) == 0:
        raise ValueError("a flat screen, or the eye in its plane")
    return view
