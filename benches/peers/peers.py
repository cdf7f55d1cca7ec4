#!/usr/bin/env python3
"""lancer beside POV-Ray, Tachyon and Embree: the same scenes, the same run, one after the other.

    cargo build --release
    benches/peers/peers.py                              everything, as Markdown on standard output
    benches/peers/peers.py --write docs/performance.md  the same, put between the document's marks
    benches/peers/peers.py --scenes course knot --rounds 3

It installs the Debian packages povray, tachyon, libembree-dev and g++ where they are missing and it may (as root or
with `sudo -n`); a peer that cannot be had is left out, and that is said. Scenes, facets and rays come from
`lancer bench --export`.

In each round every program has its turn, so that what disturbs the machine disturbs all of them; medians count. The
work of other processes during a run is read from /proc/stat: a run beside which others used more than --disturbance of
a core is repeated, at most --retries times, and marked with † if that did not help.

Python 3.9 or later, nothing else.
"""

import argparse
import datetime
import json
import re
import statistics
import subprocess
import tempfile
from pathlib import Path

from programs import PACKAGES, SMALLEST, machine, pixels, povray_rays, povray_tracing, provide, say, version
from tables import PICTURE_NOTES, RAY_NOTES, median, shown, table, times
from turns import Turns

ROOT = Path(__file__).resolve().parents[2]

# Whole pictures; facets alone, for Embree; one surface in few and in many facets, for the growth of cost.
PICTURES = [
    "course:1",
    "sphereflake:4",
    "sphereflake:6",
    "tetrahedron:8",
    "mountain:8",
    "knot:100",
    "field:708",
    "field:1415",
    "nest:6",
]
FACETS = ["pebble:59", "knot:100", "field:708", "field:1415"]
GROWTH = ["field:71", "field:1415"]
KINDS = ["primary", "shadow", "reflected", "diffuse"]

# What each program itself says that tracing took, in seconds.
TRACING = {
    "lancer": lambda run: json.loads(run.output)["pictures"][0]["render"],
    "POV-Ray": povray_tracing,
    "Tachyon": lambda run: run.number(r"Ray Tracing Time:\s+([\d.]+)"),
}

# The rays of all kinds that each program itself counts; Tachyon counts none.
RAYS = {
    "lancer": lambda run: json.loads(run.output)["pictures"][0]["rays"]["total"],
    "POV-Ray": povray_rays,
    "Tachyon": lambda run: None,
}


def wall(run):
    """Seconds of the clock that a run took, from its start to its end."""
    return run.wall


def processor(run):
    """Seconds that the processors worked for a run."""
    return run.cpu


def memory(run):
    """The most memory that a run had, in MiB."""
    return run.memory


def rate(program, run):
    """Million rays of all kinds per second of tracing, as far as the program counts them."""
    rays, seconds = RAYS[program](run), TRACING[program](run)
    return None if rays is None or not seconds else rays / seconds / 1e6



class Comparison:
    """Everything that is measured, and the text that comes of it."""

    def __init__(self, options, folder, peers):
        self.options, self.folder, self.peers = options, folder, peers
        self.turns = Turns(folder, options.disturbance, options.retries)
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
            runs = self.turns.rounds(self.picture_programs(stem, *files, with_text=name.startswith("course")), rounds)
            mine = runs.get("lancer", [])
            for program, taken in runs.items():
                self.results["pictures"].setdefault(name, {})[program] = {
                    "wall": median(taken, wall),
                    "cpu": median(taken, processor),
                    "memory": median(taken, memory),
                    "tracing": median(taken, TRACING[program]) if program in TRACING else None,
                    "foreign": [round(run.foreign, 3) for run in taken],
                }
                if program == "lancer P3":
                    texts.append((name, median(taken, wall), median(mine, wall)))
                    continue
                first = program == next(iter(runs))
                row = [name if first else "", f"{scene['primitives']}" if first else "", program]
                row += [shown(taken, wall, 3), shown(taken, TRACING[program], 3)]
                row += [shown(taken, lambda run: rate(program, run), 1), shown(taken, processor), shown(taken, memory, 0)]
                if mine and program != "lancer":
                    row += [times(median(taken, wall) / median(mine, wall))]
                    row += [times(median(taken, TRACING[program]) / median(mine, TRACING["lancer"]))]
                    row += [times(median(taken, processor) / median(mine, processor)), self.agreement(stem, program)]
                rows.append(row)
        heads = ["scene", "primitives", "program", "whole process s", "tracing s", "M rays/s", "processor s", "MiB"]
        more = ["whole, × lancer", "tracing, × lancer", "processor, × lancer", "pixels within 2/255 of lancer's"]
        self.text += [f"### Pictures, {self.options.size}, {self.options.threads} threads", ""]
        self.text += table(heads + (more if self.lancer else []), rows)
        for name, plain, binary in texts:
            self.text += [
                f"As text (P3), which no peer writes, lancer's `{name}` takes {plain:.3f} s instead of {binary:.3f} s.",
                "",
            ]
        self.text += PICTURE_NOTES

    def agreement(self, stem, program):
        """How many pixels differ from lancer's by at most 2 of 255 in every channel."""
        peer = {"POV-Ray": "povray", "Tachyon": "tachyon"}[program]
        mine, theirs = (pixels(self.folder / f"{stem}.{maker}.ppm") for maker in ("lancer", peer))
        if mine is None or theirs is None or len(mine) != len(theirs):
            return "–"
        near = [abs(a - b) <= 2 for a, b in zip(mine, theirs)]
        equal = sum(map(lambda *channels: all(channels), near[0::3], near[1::3], near[2::3]))
        return f"{300 * equal / len(mine):.1f} %"

    def smallest(self):
        say("the smallest picture")
        for name, text in SMALLEST.items():
            (self.folder / name).write_text(text, encoding="utf-8")
        programs = self.picture_programs("smallest", *SMALLEST)
        for program in programs:
            programs[program] = [word for word in programs[program] if word not in ("--stats=json", "+V")]
        runs = self.turns.rounds(programs, self.options.small_rounds)
        mine = median(runs.get("lancer", []), wall)
        rows = []
        for program, taken in runs.items():
            walls = sorted(1e3 * run.wall for run in taken)
            self.results.setdefault("smallest", {})[program] = walls
            middle = statistics.median(walls)
            row = [program, f"{middle:.1f}", f"{walls[0]:.1f}", f"{walls[-1]:.1f}"]
            row.append(f"{1e3 * statistics.median(run.cpu for run in taken):.1f}")
            if mine:
                row.append(times(middle / 1e3 / mine) if program != "lancer" else "")
            rows.append(row)
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
                conditions = ["--size", self.options.size, "--threads", threads, "--repeat", 3]
                programs["lancer"] = [lancer, "bench", name, "--json", "-q", *conditions]
            runs = self.turns.rounds(programs, self.options.rounds)
            marked = {key: 2 * sum(run.marked for run in taken) > len(taken) for key, taken in runs.items()}
            found = {key: [json.loads(run.output) for run in taken] for key, taken in runs.items()}
            mine = [report["scenes"][0] for report in found.get("lancer", [])]
            theirs = found["embree"]
            self.results["rays"][name] = {"lancer": mine, "embree": theirs}
            mark = " †" if any(marked.values()) else ""
            for kind in KINDS:
                rows.append([name if kind == KINDS[0] else "", *casting(kind, theirs, mine, threads, mark)])
            count = theirs[0]["facets"]
            builds.append([f"{name}{mark}", f"{count}", *building(theirs, mine, count)])
        heads = ["scene", "rays", "how many", "Embree's best, M/s", "its mode", "its 1 / 8 / 16, M/s", "met otherwise"]
        more = ["lancer M/s", "lancer : Embree", "by processor time"] if self.lancer else []
        self.text += [f"### Rays by themselves, {self.options.size}, {self.options.threads} threads", ""]
        self.text += table(heads + more, rows) + RAY_NOTES
        heads = ["scene", "facets", "Embree (medium) ms", "M facets/s", "bytes a facet"]
        more = ["lancer ms", "M facets/s", "bytes a facet", "lancer's speed : Embree's", "by processor time"]
        self.text += [f"### Building, {self.options.threads} threads", ""]
        self.text += table(heads + (more if self.lancer else []), builds)

    def growth(self):
        say("growth")
        size, threads = self.options.size, self.options.threads
        command = [self.options.lancer, "bench", *GROWTH, "--json", "-q", "--size", size, "--threads", threads]
        runs = self.turns.rounds({"lancer": command}, self.options.rounds)["lancer"]
        reports = [json.loads(run.output)["scenes"] for run in runs]
        frames = [statistics.median(report[at]["frame"]["seconds"] for report in reports) for at in range(2)]
        counts = [reports[0][at]["primitives"] for at in range(2)]
        self.results["growth"] = dict(zip(map(str, counts), frames))
        few, many = (f"in {count} facets {1e3 * frame:.1f} ms" for count, frame in zip(counts, frames))
        times_longer, times_more = frames[1] / frames[0], counts[1] / counts[0]
        self.text += [
            "### The growth of cost",
            "",
            f"A picture of the same surface takes {few}, {many}: {times_longer:.1f} times as long for "
            f"{times_more:.0f} times the facets.",
            "",
        ]

    def measure(self):
        """Measures everything that was asked for; gives the lines of the text."""
        pictures = list(filter(self.is_chosen, PICTURES))
        facets = list(filter(self.is_chosen, FACETS)) if "embree" in self.peers else []
        names = list(dict.fromkeys(pictures + facets))
        self.exported = self.export(names) if names else {}
        if pictures:
            self.pictures(pictures)
        if self.is_chosen("smallest"):
            self.smallest()
        if facets:
            self.rays(facets)
        if self.lancer and all(map(self.is_chosen, GROWTH)):
            self.growth()
        return self.heading() + self.text

    def is_chosen(self, name):
        chosen = self.options.scenes
        return not chosen or name in chosen or name.split(":")[0] in chosen

    def heading(self):
        told = subprocess.run([str(self.options.lancer), "--version"], capture_output=True, text=True).stdout.strip()
        programs = [] if self.options.peers_only else [told]
        for peer, package in (("povray", "povray"), ("tachyon", "tachyon"), ("embree", "libembree3-3")):
            is_there = peer in self.peers
            programs.append(f"{package} {version(package)}" if is_there else f"{peer} was not there and is left out")
        lines = [
            f"{self.results['date']}, on {machine()}. Programs, the peers from Debian's packages: "
            f"{', '.join(programs)}. {self.options.rounds} rounds, in each of which every program had its turn; medians.",
            "",
        ]
        if self.turns.disturbed:
            lines += [
                f"Beside {self.turns.disturbed} of {self.turns.runs} runs other processes used more than "
                f"{self.options.disturbance} of a core (†, where most runs of a figure were such).",
                "",
            ]
        return lines


def casting(kind, theirs, mine, threads, mark):
    """A row of the table of rays: Embree's figures, and lancer's where it was timed."""
    count = theirs[0][kind]["rays"]

    def rates(clock):
        """Million rays per second in each of Embree's modes; by processor time, as if no thread ever waited."""
        per = 1 if clock == "seconds" else threads
        modes = range(len(theirs[0][kind]["modes"]))
        return [statistics.median(per * count / run[kind]["modes"][at][clock] for run in theirs) / 1e6 for at in modes]

    modes = rates("seconds")
    best = max(range(len(modes)), key=lambda at: modes[at])
    mode = theirs[0][kind]["modes"][best]
    otherwise = max(each["otherwise"] for each in theirs[0][kind]["modes"])
    row = [
        kind,
        f"{count}",
        f"{modes[best]:.1f}{mark}",
        f"{mode['width']}, {'coherent' if mode['coherent'] else 'incoherent'}",
        " / ".join(f"{max(modes[at], modes[at + 1]):.1f}" for at in (0, 2, 4)),
        f"{otherwise}",
    ]
    if mine:
        own = statistics.median(run[kind]["rays"] / run[kind]["seconds"] for run in mine) / 1e6
        by_processor = statistics.median(threads * run[kind]["rays"] / run[kind]["processor"] for run in mine) / 1e6
        row += [f"{own:.1f}", f"{own / modes[best]:.2f}×", f"{by_processor / max(rates('processor')):.2f}×"]
    return row


def building(theirs, mine, count):
    """The figures of the table of building: Embree's, and lancer's where it was timed."""

    def took(reports, clock):
        return statistics.median(report["build"][clock] for report in reports)

    row = []
    for reports in filter(None, (theirs, mine)):
        build = took(reports, "seconds")
        row += [f"{1e3 * build:.1f}", f"{count / build / 1e6:.2f}", f"{reports[0]['bytes'] / count:.1f}"]
    if mine:
        row += [f"{took(theirs, clock) / took(mine, clock):.2f}×" for clock in ("seconds", "processor")]
    return row


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
    parser.add_argument("--scenes", nargs="+", metavar="NAME", help="only these; `smallest` is the smallest picture")
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
    lines = comparison.measure()
    if options.work:
        (folder / "results.json").write_text(json.dumps(comparison.results, indent=1), encoding="utf-8")
    if options.write:
        write(options.write, lines)
    else:
        print("\n".join(lines))


if __name__ == "__main__":
    main()
