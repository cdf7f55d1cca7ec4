"""Runs of programs that take turns: how long each took, and what else the machine did meanwhile."""

import os
import re
import resource
import subprocess
import tempfile
import time


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


class Turns:
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
