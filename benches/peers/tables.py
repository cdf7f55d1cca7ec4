"""Figures as Markdown, and what must be said beside them."""

import statistics

PICTURE_NOTES = """\
What the peers do otherwise, where it matters:

* POV-Ray sums the terms of a point where the subject composes them by ⊕, so the scenes are exported with
  `compose="add"`. Its transparent objects filter shadows, ours block them. It is told to trace every ray, as lancer
  does, also those that would change a pixel by less than 1/255 (`adc_bailout 0`). It gets its own boxes for cubes. Of
  its whole time, some tenths of a second pass before and after the work.
* Tachyon has no refraction: light goes straight through glass, which is less work. Coefficients for each channel
  become one colour and one strength, so coloured mirrors and ambient light differ. It gets one triangle at a time,
  because its arrays of vertices have smooth normals.
""".split("\n")

RAY_NOTES = """\
Embree answers the very rays that lancer casts (origins and directions of 32 bits), in single rays and in packets of 8
and 16 neighbours, each with the flag for coherent and for incoherent rays; the best of the six counts. «Met otherwise»
are rays of which one program finds a hit and the other none, or another distance; Embree computes with 32 bits, lancer
with 64. Embree has no infinite plane, so only scenes of facets are compared; it answers rays and computes no light. Its
defaults are kept, so its test of a triangle is not the watertight one. By processor time a ratio is disturbed less by
what else the machine does.
""".split("\n")


def table(heads, rows):
    """A table; rows may be shorter than its head."""
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return lines + ["| " + " | ".join(row + [""] * (len(heads) - len(row))) + " |" for row in rows] + [""]


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
