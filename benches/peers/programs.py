"""The programs that are compared: how they are had, their smallest picture, and the machine they run on."""

import os
import platform
import re
import subprocess
import sys
from pathlib import Path

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
camera {
  perspective location <0, 0, 5> direction <0, 0, -1> right <0.8284271247461902, 0, 0> up <0, 0.8284271247461902, 0>
}
light_source { <-3, 4, 5> rgb 1 }
sphere { 0, 1 texture { pigment { rgb 0.6 } finish { ambient 0.0666666666666667 diffuse 1 } } }
""",
    "smallest.dat": """BEGIN_SCENE
RESOLUTION 64 64
CAMERA ZOOM 1.2071067811865475 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 5
CENTER 0 0 -5 VIEWDIR 0 0 1 UPDIR 0 1 0 END_CAMERA
BACKGROUND 0 0 0
LIGHT CENTER -3 4 -5 RAD 0.01 COLOR 1 1 1
SPHERE CENTER 0 0 0 RAD 1
TEXTURE AMBIENT 0.0666666666666667 DIFFUSE 0.6 SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 0
END_SCENE
""",
}


def say(text):
    print(text, file=sys.stderr, flush=True)


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


def povray_tracing(run):
    """POV-Ray's own trace time, which it gives in hours, minutes, seconds and in seconds alone."""
    return run.number(r"Trace Time:[^(]*\(([\d.]+) seconds\)")


def povray_rays(run):
    """POV-Ray's own count: rays of all kinds but shadow rays, and tests of shadow rays."""
    rays, shadow = run.number(r"\nRays:\s+(\d+)"), run.number(r"Shadow Ray Tests:\s+(\d+)")
    return None if rays is None else rays + (shadow or 0)


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
    return f"{os.cpu_count()} processors {model} ({widest}), {gib:.0f} GiB, {system_name()}"


def system_name():
    """The name of the distribution."""
    try:
        for line in Path("/etc/os-release").read_text(encoding="utf-8").splitlines():
            if line.startswith("PRETTY_NAME="):
                return line.partition("=")[2].strip('"')
    except OSError:
        pass
    return platform.system()
