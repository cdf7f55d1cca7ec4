#!/usr/bin/env python3
"""lancer beside POV-Ray, Tachyon and Embree: the same scenes, the same run, one after the other.

    cargo build --release
    benches/peers/peers.py                              everything, as Markdown on standard output
    benches/peers/peers.py --write docs/performance.md  the same, put between the document's marks
    benches/peers/peers.py --scenes course knot --rounds 3

It installs the Debian packages povray, tachyon, libembree-dev and g++ where they are missing and it may (as root or with
`sudo -n`); a peer that cannot be had is left out, and that is said. Scenes, facets and rays come from
`lancer bench --export`.

In each round every program has its turn, so that what disturbs the machine disturbs all of them; medians count. The work
of other processes during a run is read from /proc/stat: a run beside which others used more than --disturbance of a core
is repeated, at most --retries times, and marked with † if that did not help.

Python 3.9 or later, nothing else.
"""

import argparse
import datetime
import json
import os
import platform
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# Whole pictures, all of them; facets alone, for Embree; the one surface in more and more facets, for the growth of cost.
PICTURES = ["course", "sphereflake:4", "sphereflake:6", "tetrahedron:8", "mountain:8", "knot:100", "field:708", "nest:6"]
FACETS = ["pebble:59", "knot:100", "field:708", "field:1415"]
GROWTH = ["field:71", "field:1415"]
KINDS = ["primary", "shadow", "reflected", "diffuse"]

PACKAGES = {
    "povray": (["povray", "--version"], "povray"),
    "tachyon": (["sh", "-c", "command -v tachyon"], "tachyon"),
    "embree": (["sh", "-c", "echo '#include <embree3/rtcore.h>' | g++ -x c++ -fsyntax-only -"], "libembree-dev g++"),
}

SMALLEST = {
    "smallest.xml": """<scene version="1" name="One lamp, one sphere">
  <light name="lamp" position="-3 4 5"/>
  <sphere name="ball" center="0 0 0" radius="1"/>
</scene>
""",
    "smallest.view.xml": """<view version="1" name="front" width="64" height="64">
  <eye at="0 0 5" look-at="0 0 0"/>
</view>
""",
    "smallest.pov": """#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 1 }
camera { perspective location <0, 0, 5> direction <0, 0, -1> right <0.8284271247461902, 0, 0> up <0, 0.8284271247461902, 0> }
light_source { <-3, 4, 5> rgb 1 }
sphere { 0, 1 texture { pigment { rgb 0.6 } finish { ambient 0.0666666666666667 diffuse 1 } } }
""",
    "smallest.dat": """BEGIN_SCENE
RESOLUTION 64 64
CAMERA ZOOM 1.2071067811865475 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 5
CENTER 0 0 -5 VIEWDIR 0 0 1 UPDIR 0 1 0 END_CAMERA
BACKGROUND 0 0 0
LIGHT CENTER -3 4 -5 RAD 0.01 COLOR 1 1 1
SPHERE CENTER 0 0 0 RAD 1 TEXTURE AMBIENT 0.0666666666666667 DIFFUSE 0.6 SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 0
END_SCENE
""",
}


def say(text):
    print(text, file=sys.stderr, flush=True)


# ---- the programs ----------------------------------------------------------------------------------------------------


def succeeds(command):
    try:
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "stdin": subprocess.DEVNULL}
        return subprocess.run(command, **quiet).returncode == 0
    except OSError:
        return False


def provide(peer, may_install):
    """Whether the peer is there, after an attempt to install it."""
    probe, packages = PACKAGES[peer]
    if succeeds(probe):
        return True
    if may_install:
        say(f"installing {packages}")
        os.environ["DEBIAN_FRONTEND"] = "noninteractive"
        install = f"apt-get update -q && apt-get install -q -y --no-install-recommends {packages}"
        if any(succeeds(command) for command in (["sh", "-c", install], ["sudo", "-n", "sh", "-c", install])):
            return succeeds(probe)
    say(f"{peer} is not here and is left out; as root: apt-get install {packages}")
    return False


def version(package):
    """The version of a Debian package, or nothing."""
    try:
        shown = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True)
        return shown.stdout.strip()
    except OSError:
        return ""


# ---- one run ---------------------------------------------------------------------------------------------------------


def busy_ticks():
    """Ticks that all processors were busy since the start."""
    with open("/proc/stat", encoding="ascii") as stat:
        user, nice, system, _idle, _wait, irq, softirq, steal, *_ = map(int, stat.readline().split()[1:])
    return user + nice + system + irq + softirq + steal


class Run:
    """What a run of a program took: wall and processor seconds, the most memory, and what others did meanwhile."""

    def __init__(self, command, folder):
        before, ticks = resource.getrusage(resource.RUSAGE_CHILDREN), busy_ticks()
        started = time.perf_counter()
        with tempfile.TemporaryFile() as output:
            child = subprocess.Popen(
                command, cwd=folder, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT
            )
            _, status, usage = os.wait4(child.pid, 0)
            self.wall = time.perf_counter() - started
            child.returncode = os.waitstatus_to_exitcode(status)
            output.seek(0)
            self.output = output.read().decode(errors="replace")
        if child.returncode != 0:
            raise SystemExit(f"{' '.join(map(str, command))}: exit code {child.returncode}\n{self.output[-2000:]}")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.cpu = usage.ru_utime + usage.ru_stime
        self.memory = usage.ru_maxrss / 1024
        own = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        busy = (busy_ticks() - ticks) / os.sysconf("SC_CLK_TCK")
        # ticks are coarse: a run of a few of them says nothing about others
        self.foreign = max(0.0, busy - own) / self.wall if self.wall > 0.3 else 0.0

    def number(self, pattern):
        """The number of a line of the program's own output."""
        found = re.search(pattern, self.output)
        return float(found.group(1)) if found else None


class Bench:
    """Runs programs in turn, and repeats a run that others disturbed."""

    def __init__(self, folder, disturbance, retries):
        self.folder, self.disturbance, self.retries = folder, disturbance, retries
        self.runs = self.disturbed = 0

    def run(self, command):
        best = None
        for _ in range(self.retries + 1):
            run = Run([str(word) for word in command], self.folder)
            if best is None or run.foreign < best.foreign:
                best = run
            if best.foreign <= self.disturbance:
                break
        self.runs += 1
        best.marked = best.foreign > self.disturbance
        self.disturbed += best.marked
        return best

    def rounds(self, programs, count):
        """The runs of each program, one of each in every round."""
        runs = {name: [] for name in programs}
        for number in range(count):
            # every second round backwards, so that none always follows the same one
            for name in list(programs)[:: 1 if number % 2 == 0 else -1]:
                runs[name].append(self.run(programs[name]))
        return runs


# ---- tables ----------------------------------------------------------------------------------------------------------


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def median(runs, of):
    values = [of(run) for run in runs]
    return None if not values or None in values else statistics.median(values)


def shown(runs, of, digits=2):
    """The median of the runs, marked if most of them were disturbed."""
    value = median(runs, of)
    if value is None:
        return "–"
    mark = " †" if 2 * sum(run.marked for run in runs) > len(runs) else ""
    return f"{value:.{digits}f}{mark}"


def times(ratio):
    return "–" if ratio is None else f"{ratio:.1f}×" if ratio < 10 else f"{ratio:.0f}×"


# ---- what is measured ------------------------------------------------------------------------------------------------


class Comparison:
    def __init__(self, options, folder, peers):
        self.options, self.folder, self.peers = options, folder, peers
        self.bench = Bench(folder, options.disturbance, options.retries)
        self.lancer = [] if options.peers_only else [options.lancer]
        self.text = []
        self.results = {"date": datetime.date.today().isoformat(), "pictures": {}, "rays": {}}

    def export(self, names):
        width, height = self.options.size.split("x")
        command = [self.options.lancer, "bench", "--export", self.folder, "--size", self.options.size, "-q", *names]
        say("exporting " + " ".join(names))
        subprocess.run([str(word) for word in command], check=True)
        manifest = json.loads((self.folder / "scenes.json").read_text(encoding="utf-8"))
        assert (manifest["version"], manifest["width"], manifest["height"]) == (1, int(width), int(height))
        return {scene["name"]: scene for scene in manifest["scenes"]}

    def picture_programs(self, stem, scene, view, povray, tachyon, with_text=False):
        """A command for each program, all with as many threads and the same size; binary PPM."""
        threads = str(self.options.threads)
        size = re.search(r"(\d+)x(\d+)", self.options.size if stem != "smallest" else "64x64").groups()
        programs = {}
        for lancer in self.lancer:
            base = [lancer, scene, view, f"{stem}.lancer.ppm", "--threads", threads, "-q", "--stats=json"]
            programs["lancer"] = base + ["--binary"]
            if with_text:
                programs["lancer P3"] = base
        if "povray" in self.peers:
            flags = ["-D", "-A", "-V", "+FP", "File_Gamma=1.0", "+GA", f"+WT{threads}", f"+W{size[0]}", f"+H{size[1]}"]
            programs["POV-Ray"] = ["povray", povray, *flags, f"+O{stem}.povray.ppm"]
        if "tachyon" in self.peers:
            flags = ["+V", "-numthreads", threads, "-shade_phong", "-format", "PPM", "-res", *size]
            programs["Tachyon"] = ["tachyon", tachyon, *flags, "-o", f"{stem}.tachyon.ppm"]
        return programs

    def pictures(self, scenes):
        say("pictures")
        rows, texts = [], []
        for name in scenes:
            scene, rounds = self.exported[name], self.options.rounds
            say(f"  {name}")
            stem = name.replace(":", "-")
            files = [scene[kind] for kind in ("scene", "view", "povray", "tachyon")]
            runs = self.bench.rounds(self.picture_programs(stem, *files, with_text=name.startswith("course")), rounds)
            tracing = {
                "lancer": lambda run: json.loads(run.output)["pictures"][0]["render"],
                "POV-Ray": povray_tracing,
                "Tachyon": lambda run: run.number(r"Ray Tracing Time:\s+([\d.]+)"),
            }
            mine = median(runs.get("lancer", []), lambda run: run.wall)
            mine_tracing = median(runs.get("lancer", []), tracing["lancer"])
            for program, taken in runs.items():
                whole = median(taken, lambda run: run.wall)
                self.results["pictures"].setdefault(name, {})[program] = {
                    "wall": whole,
                    "cpu": median(taken, lambda run: run.cpu),
                    "memory": median(taken, lambda run: run.memory),
                    "tracing": median(taken, tracing[program]) if program in tracing else None,
                    "foreign": [round(run.foreign, 3) for run in taken],
                }
                if program == "lancer P3":
                    texts.append((name, whole, mine))
                    continue
                pixels = self.agreement(stem, program) if mine else None
                rows.append([
                    name if program == next(iter(runs)) else "",
                    f"{scene['primitives']}" if program == next(iter(runs)) else "",
                    program,
                    shown(taken, lambda run: run.wall, 3),
                    shown(taken, tracing[program], 3),
                    shown(taken, lambda run: run.cpu),
                    shown(taken, lambda run: run.memory, 0),
                    times(whole / mine) if mine and program != "lancer" else "",
                    times(median(taken, tracing[program]) / mine_tracing) if mine and program != "lancer" else "",
                    "" if pixels is None else f"{pixels:.1f} %",
                ])
        heads = ["scene", "primitives", "program", "whole process s", "tracing s", "processor s", "MiB"]
        more = ["whole, × lancer", "tracing, × lancer", "pixels within 2/255 of lancer's"]
        if not self.lancer:
            rows = [row[:7] for row in rows]
        self.text += [f"### Pictures, {self.options.size}, {self.options.threads} threads", ""]
        self.text += table(heads + (more if self.lancer else []), rows)
        for name, plain, binary in texts:
            self.text += [
                f"As text (P3), which no peer writes, lancer's `{name}` takes {plain:.3f} s instead of {binary:.3f} s.",
                "",
            ]
        self.text += PICTURE_NOTES

    def agreement(self, stem, program):
        """Per cent of the pixels that differ from lancer's by at most 2 of 255 in every channel."""
        if program == "lancer":
            return None
        mine, theirs = (pixels(self.folder / f"{stem}.{kind}.ppm") for kind in ("lancer", {"POV-Ray": "povray"}.get(program, "tachyon")))
        if mine is None or theirs is None or len(mine) != len(theirs):
            return None
        near = sum(
            abs(mine[at] - theirs[at]) <= 2 and abs(mine[at + 1] - theirs[at + 1]) <= 2 and abs(mine[at + 2] - theirs[at + 2]) <= 2
            for at in range(0, len(mine), 3)
        )
        return 300.0 * near / len(mine)

    def smallest(self):
        say("the smallest picture")
        for name, text in SMALLEST.items():
            (self.folder / name).write_text(text, encoding="utf-8")
        programs = self.picture_programs("smallest", *SMALLEST)
        for program in programs:
            programs[program] = [word for word in programs[program] if word not in ("--stats=json", "+V")]
        runs = self.bench.rounds(programs, self.options.small_rounds)
        mine = median(runs.get("lancer", []), lambda run: run.wall)
        rows = []
        for program, taken in runs.items():
            walls = sorted(1e3 * run.wall for run in taken)
            self.results.setdefault("smallest", {})[program] = walls
            row = [program, f"{statistics.median(walls):.1f}", f"{walls[0]:.1f}", f"{walls[-1]:.1f}"]
            row += [f"{1e3 * statistics.median(run.cpu for run in taken):.1f}"]
            rows.append(row + ([times(statistics.median(walls) / 1e3 / mine) if program != "lancer" else ""] if mine else []))
        heads = ["program", "median ms", "least ms", "most ms", "processor ms"] + (["× lancer"] if self.lancer else [])
        self.text += [
            f"### The smallest picture: 64x64, one sphere, the whole process, {self.options.small_rounds} runs each",
            "",
            *table(heads, rows),
        ]

    def rays(self, scenes):
        say("rays")
        program = self.folder / "embree"
        source = ROOT / "benches/peers/embree.cpp"
        command = ["g++", "-O3", "-march=native", "-std=c++17", source, "-o", program, "-lembree3", "-lpthread"]
        subprocess.run([str(word) for word in command], check=True)
        rows, builds = [], []
        for name in scenes:
            say(f"  {name}")
            scene, threads = self.exported[name], self.options.threads
            programs = {"embree": [program, scene["facets"], scene["rays"], threads, 3, 3]}
            for lancer in self.lancer:
                size = self.options.size
                programs["lancer"] = [lancer, "bench", name, "--json", "-q", "--size", size, "--threads", threads, "--repeat", 3]
            runs = self.bench.rounds(programs, self.options.rounds)
            marked = {key: 2 * sum(run.marked for run in taken) > len(taken) for key, taken in runs.items()}
            found = {key: [json.loads(run.output) for run in taken] for key, taken in runs.items()}
            mine = [report["scenes"][0] for report in found.get("lancer", [])]
            theirs = found["embree"]
            self.results["rays"][name] = {"lancer": mine, "embree": theirs}
            mark = " †" if any(marked.values()) else ""
            for kind in KINDS:
                modes = [
                    statistics.median(run[kind]["rays"] / run[kind]["modes"][mode]["seconds"] for run in theirs) / 1e6
                    for mode in range(len(theirs[0][kind]["modes"]))
                ]
                best = max(range(len(modes)), key=lambda mode: modes[mode])
                mode = theirs[0][kind]["modes"][best]
                otherwise = max(each["otherwise"] for each in theirs[0][kind]["modes"])
                rows.append([
                    name if kind == KINDS[0] else "",
                    kind,
                    f"{theirs[0][kind]['rays']}",
                    f"{modes[best]:.1f}{mark}",
                    f"{mode['width']}, {'coherent' if mode['coherent'] else 'incoherent'}",
                    " / ".join(f"{max(modes[at], modes[at + 1]):.1f}" for at in (0, 2, 4)),
                    f"{otherwise}",
                ])
                if mine:
                    rate = statistics.median(run[kind]["rays"] / run[kind]["seconds"] for run in mine) / 1e6
                    rows[-1] += [f"{rate:.1f}", f"{rate / modes[best]:.2f}×"]
            count = theirs[0]["facets"]
            build = statistics.median(run["build"] for run in theirs)
            builds.append([name, f"{count}", f"{1e3 * build:.1f}{mark}", f"{count / build / 1e6:.2f}", f"{theirs[0]['bytes'] / count:.1f}"])
            if mine:
                own = statistics.median(run["build"] for run in mine)
                builds[-1] += [f"{1e3 * own:.1f}", f"{count / own / 1e6:.2f}", f"{mine[0]['bytes'] / count:.1f}", f"{build / own:.2f}×"]
        with_lancer = bool(self.lancer)
        heads = ["scene", "rays", "how many", "Embree's best, M/s", "its mode", "its 1 / 8 / 16, M/s", "met otherwise"]
        self.text += [f"### Rays by themselves, {self.options.size}, {self.options.threads} threads", ""]
        self.text += table(heads + (["lancer M/s", "lancer : Embree"] if with_lancer else []), rows)
        self.text += RAY_NOTES
        self.text += [f"### Building, {self.options.threads} threads", ""]
        heads = ["scene", "facets", "Embree (medium) ms", "M facets/s", "bytes a facet"]
        more = ["lancer ms", "M facets/s", "bytes a facet", "lancer's speed : Embree's"]
        self.text += table(heads + (more if with_lancer else []), builds)

    def growth(self):
        say("growth")
        size, threads = self.options.size, self.options.threads
        command = [self.options.lancer, "bench", *GROWTH, "--json", "-q", "--size", size, "--threads", threads]
        runs = self.bench.rounds({"lancer": command}, self.options.rounds)["lancer"]
        reports = [json.loads(run.output)["scenes"] for run in runs]
        frames = [statistics.median(report[at]["frame"]["seconds"] for report in reports) for at in range(2)]
        counts = [reports[0][at]["primitives"] for at in range(2)]
        self.results["growth"] = dict(zip(map(str, counts), frames))
        self.text += [
            "### The growth of cost",
            "",
            f"The same surface in {counts[0]} facets takes {1e3 * frames[0]:.1f} ms a picture, in {counts[1]} facets "
            f"{1e3 * frames[1]:.1f} ms: {frames[1] / frames[0]:.1f} times as long for {counts[1] / counts[0]:.0f} times "
            "the facets.",
            "",
        ]

    def all(self):
        chosen = lambda names: [name for name in names if self.is_chosen(name)]
        pictures = ["course:1" if name == "course" else name for name in chosen(PICTURES)]
        facets = chosen(FACETS) if "embree" in self.peers else []
        self.exported = self.export(list(dict.fromkeys(pictures + facets)))
        if pictures:
            self.pictures(pictures)
        if not self.options.scenes:
            self.smallest()
        if facets:
            self.rays(facets)
        if self.lancer and chosen(GROWTH) == GROWTH:
            self.growth()
        return self.heading() + self.text

    def is_chosen(self, name):
        chosen = self.options.scenes
        return not chosen or name in chosen or name.split(":")[0] in chosen

    def heading(self):
        told = subprocess.run([str(self.options.lancer), "--version"], capture_output=True, text=True).stdout.strip()
        programs = [] if self.options.peers_only else [told]
        for peer, package in (("povray", "povray"), ("tachyon", "tachyon"), ("embree", "libembree3-3")):
            programs.append(f"{package} {version(package)}" if peer in self.peers else f"{peer} was not there and is left out")
        lines = [
            f"{datetime.date.today().isoformat()}, on {machine()}. Programs, from Debian's packages where they are not lancer: "
            + ", ".join(programs)
            + f". {self.options.rounds} rounds, in each of which every program had its turn; medians.",
            "",
        ]
        if self.bench.disturbed:
            lines += [
                f"Beside {self.bench.disturbed} of {self.bench.runs} runs other processes used more than "
                f"{self.options.disturbance} of a core (†, where most runs of a figure were such).",
                "",
            ]
        return lines


def povray_tracing(run):
    """POV-Ray's own trace time, which it gives in hours, minutes, seconds and in seconds alone."""
    return run.number(r"Trace Time:[^(]*\(([\d.]+) seconds\)")


PICTURE_NOTES = [
    "What the peers do otherwise, where it matters:",
    "",
    "* POV-Ray sums the terms of a point where the subject composes them by ⊕, so the scenes are exported with",
    '  `compose="add"`. Its transparent objects filter shadows, ours block them. It drops rays that would change a pixel by',
    "  less than 1/255 (`adc_bailout`), its default; lancer traces every ray. It gets its own boxes for cubes. Of its whole",
    "  time, some tenths of a second pass before and after the work.",
    "* Tachyon has no refraction: light goes straight through glass, which is less work. Coefficients for each channel",
    "  become one colour and one strength, so coloured mirrors and ambient light differ. It gets one triangle at a time,",
    "  because its arrays of vertices have smooth normals.",
    "",
]

RAY_NOTES = [
    "Embree answers the very rays that lancer casts (origins and directions of 32 bits), in single rays and in packets of 8",
    "and 16 neighbours, each with the flag for coherent and for incoherent rays; the best of the six counts. «Met otherwise»",
    "are rays of which one program finds a hit and the other none, or another distance; Embree computes with 32 bits, lancer",
    "with 64. Embree has no infinite plane, so only scenes of facets are compared; it answers rays and computes no light.",
    "",
]


def pixels(path):
    """The bytes of a binary PPM without comments, as the three programs write them."""
    try:
        data = path.read_bytes()
    except OSError:
        return None
    found = re.match(rb"P6\s+(?:#[^\n]*\n\s*)*(\d+)\s+(\d+)\s+255\s", data)
    return data[found.end() :] if found else None


def machine():
    """The processor, its count, memory and system."""
    model = "unknown processor"
    flags = ""
    with open("/proc/cpuinfo", encoding="utf-8") as info:
        for line in info:
            key, _, value = line.partition(":")
            if key.strip() == "model name":
                model = value.strip()
            if key.strip() == "flags":
                flags = value.split()
    widest = next((name for flag, name in (("avx512f", "AVX-512"), ("avx2", "AVX2")) if flag in flags), "no AVX2")
    gib = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    system = platform.freedesktop_os_release().get("PRETTY_NAME", "") if hasattr(platform, "freedesktop_os_release") else ""
    return f"{os.cpu_count()} × {model} ({widest}), {gib:.0f} GiB, {system or platform.system()}"


BEGIN, END = "<!-- measured -->", "<!-- end of what was measured -->"


def write(path, lines):
    """Puts the lines between the document's marks."""
    text = path.read_text(encoding="utf-8")
    before, mark, rest = text.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not mark or not end:
        raise SystemExit(f"{path} lacks the marks {BEGIN} and {END}")
    path.write_text(before + BEGIN + "\n\n" + "\n".join(lines).rstrip() + "\n\n" + END + after, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lancer", type=Path, default=ROOT / "target/release/lancer", help="the program")
    parser.add_argument("--scenes", nargs="+", metavar="NAME", help="only these")
    parser.add_argument("--rounds", type=int, default=5, help="turns of each program (default 5)")
    parser.add_argument("--small-rounds", type=int, default=20, help="turns for the smallest picture (default 20)")
    parser.add_argument("--threads", type=int, default=2, help="threads of each program (default 2)")
    parser.add_argument("--size", default="1920x1080", help="of the pictures (default 1920x1080)")
    parser.add_argument("--disturbance", type=float, default=0.12, help="cores that others may use (default 0.12)")
    parser.add_argument("--retries", type=int, default=2, help="repetitions of a disturbed run (default 2)")
    parser.add_argument("--peers-only", action="store_true", help="do not time lancer, which still writes the scenes")
    parser.add_argument("--no-install", action="store_true", help="install nothing")
    parser.add_argument("--work", type=Path, help="folder for scenes and pictures, kept (default: a temporary one)")
    parser.add_argument("--write", type=Path, metavar="DOCUMENT", help="put the tables between the document's marks")
    options = parser.parse_args()
    if not options.lancer.is_file():
        raise SystemExit(f"{options.lancer} is not there: cargo build --release")
    options.lancer = options.lancer.resolve()
    peers = [peer for peer in PACKAGES if provide(peer, not options.no_install)]
    temporary = None if options.work else tempfile.TemporaryDirectory(prefix="lancer-peers-")
    folder = options.work or Path(temporary.name)
    folder.mkdir(parents=True, exist_ok=True)
    comparison = Comparison(options, folder.resolve(), peers)
    lines = comparison.all()
    if options.work:
        (folder / "results.json").write_text(json.dumps(comparison.results, indent=1), encoding="utf-8")
    if options.write:
        write(options.write, lines)
    else:
        print("\n".join(lines))


if __name__ == "__main__":
    main()
