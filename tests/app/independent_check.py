#!/usr/bin/env python3
"""A second opinion on the worked example, sharing no line with the program.

Runs `nineline-cli demo`, reads model.json, thread.nc and corrected.nc with its own readers, moves its own model of the
grinder (work: T(z) E_Z T(q2) S_C R(c) E_C, wheel: T(q4) S_X T(x) E_X, exact rotations, cubic splines), and measures how
far the corrected commands put the grinding point from where the original commands should put it: at every block end and
between them. Also holds the published mean errors, and that nothing but axis words changed.
Usage: independent_check.py CLI
"""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ARCSEC = math.pi / 648000.0
TOLERANCE_MM = 1e-3  # of the correction, along the blocks
ROUNDING_MM = 0.9e-3  # words of 0.001 mm and 0.001 deg: half of each, in three directions
PUBLISHED = {"X": (-0.096, 2e-6), "Z": (0.157, 2e-6), "C": (0.004, 1e-6)}  # mean error in mm, and how near


# --- rigid motions: (rotation as rows, translation)

def matrix_product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def apply(motion, p):
    rotation, shift = motion
    return [sum(rotation[i][k] * p[k] for k in range(3)) + shift[i] for i in range(3)]


def chained(*motions):
    rotation, shift = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0.0, 0.0, 0.0]
    for one in motions:
        shift = apply((rotation, shift), one[1])
        rotation = matrix_product(rotation, one[0])
    return rotation, shift


def inverse(motion):
    rotation, shift = motion
    turned = [[rotation[j][i] for j in range(3)] for i in range(3)]
    return turned, [-sum(turned[i][k] * shift[k] for k in range(3)) for i in range(3)]


def rotation_by(vector):
    """Rodrigues: the rotation about a vector by its length."""
    angle = math.sqrt(sum(v * v for v in vector))
    x, y, z = vector
    cross = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    first = math.sin(angle) / angle if angle > 1e-12 else 1.0
    second = (1 - math.cos(angle)) / angle ** 2 if angle > 1e-6 else 0.5
    square = matrix_product(cross, cross)
    return [[float(i == j) + first * cross[i][j] + second * square[i][j] for j in range(3)] for i in range(3)]


def moved(shift, turn=(0.0, 0.0, 0.0)):
    return rotation_by(turn), list(shift)


# --- cubic splines by their second derivatives

def solve(rows, right):
    """Gauss elimination with pivots; the systems here are small."""
    count = len(right)
    rows = [list(row) + [value] for row, value in zip(rows, right)]
    for i in range(count):
        pivot = max(range(i, count), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(i + 1, count):
            factor = rows[k][i] / rows[i][i]
            if factor:
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    answer = [0.0] * count
    for i in reversed(range(count)):
        answer[i] = (rows[i][count] - sum(rows[i][k] * answer[k] for k in range(i + 1, count))) / rows[i][i]
    return answer


class Spline:
    def __init__(self, start, spacing, values, periodic):
        self.start, self.spacing, self.periodic = start, spacing, periodic
        count = len(values)
        rows, right = [], []
        for i in range(count):
            row = [0.0] * count
            if not periodic and i in (0, count - 1):
                row[i], value = 1.0, 0.0  # natural end
            else:
                row[i - 1], row[i], row[(i + 1) % count] = 1.0, 4.0, 1.0
                value = 6.0 * (values[i - 1] - 2 * values[i] + values[(i + 1) % count]) / spacing ** 2
            rows.append(row)
            right.append(value)
        bends = solve(rows, right) if count > 2 else [0.0] * count
        self.values = values + values[:1] if periodic else values
        self.bends = bends + bends[:1] if periodic else bends

    def __call__(self, position):
        last = len(self.values) - 1
        place = (position - self.start) / self.spacing
        place = place % last if self.periodic else min(max(place, 0.0), float(last))
        i = min(int(place), last - 1)
        b, h = place - i, self.spacing
        a = 1.0 - b
        return (a * self.values[i] + b * self.values[i + 1]
                + ((a ** 3 - a) * self.bends[i] + (b ** 3 - b) * self.bends[i + 1]) * h * h / 6.0)


class Grinder:
    def __init__(self, model):
        joints = model["machine"]["workpiece_chain"] + model["machine"]["tool_chain"]
        offsets = {joint["axis"]: joint["offset_mm"] for joint in joints}
        self.q1, self.q2, self.q4 = offsets["Z"], offsets["C"], offsets["X"]
        self.tip = model["machine"]["tool"]["tip_mm"]
        self.tables, self.constants = {}, {}
        for effect in model["effects"]:
            if effect["effect"] == "location":
                self.constants[effect["component"]] = effect["value_arcsec"] * ARCSEC
                continue
            rotary = "start_deg" in effect
            unit = math.radians(1.0) if rotary else 1.0
            grid = (effect["start_deg" if rotary else "start_mm"], effect["spacing_deg" if rotary else "spacing_mm"])
            values = [v * 1e-3 for v in effect["values_um"]] if "values_um" in effect else \
                [v * ARCSEC for v in effect["values_arcsec"]]
            self.tables[effect["component"]] = Spline(grid[0] * unit, grid[1] * unit, values, rotary)

    def error(self, axis, position, ideal):
        if ideal:
            return moved((0, 0, 0))
        value = [self.tables[f"E{direction}{axis}"](position) for direction in "XYZABC"]
        return moved(value[:3], value[3:])

    def work(self, z, c, ideal=False):
        tilt = (0, 0, 0) if ideal else (self.constants["A0C"], self.constants["B0C"], 0)
        return chained(moved(self.q1), moved((0, 0, z)), self.error("Z", z, ideal), moved(self.q2),
                       moved((0, 0, 0), tilt), moved((0, 0, 0), (0, 0, c)), self.error("C", c, ideal))

    def wheel(self, x, ideal=False):
        tilt = (0, 0, 0) if ideal else (0, self.constants["B0X"], 0)
        return chained(moved(self.q4), moved((0, 0, 0), tilt), moved((x, 0, 0)), self.error("X", x, ideal))

    def point(self, command, ideal=False):
        """The point of the workpiece that the wheel touches."""
        x, z, c = command
        return apply(inverse(self.work(z, c, ideal)), apply(self.wheel(x, ideal), self.tip))

    def axis_errors(self, command):
        """Which ideal command touches the same point, minus the command: X, Z in mm, C in rad (contact height 0)."""
        x, z, c = command
        wx, wy, wz = self.point(command)
        turn = -math.atan2(wy, wx)
        error_c = math.remainder(turn - c, math.tau)
        offset = self.q4[2] + self.tip[2] - self.q2[2] - self.q1[2]
        return math.hypot(wx, wy) - (self.q4[0] + self.tip[0] - self.q2[0]) - x, offset - wz - z, error_c


def commands(text):
    """(line number, rapid, (x, z, c)) after each block that moves; words as plain numbers, absolute, mm and deg."""
    position, rapid = {"X": None, "Z": None, "C": 0.0}, True
    for number, line in enumerate(text.splitlines(), 1):
        line = re.sub(r"\([^)]*\)", "", line)
        words = re.findall(r"([A-Z])([-+]?\d*\.?\d+|[-+]?\d+\.)", line)
        for letter, value in words:
            if letter == "G" and float(value) in (0, 1):
                rapid = float(value) == 0
        axes = {letter: float(value) for letter, value in words if letter in position}
        position.update(axes)
        if axes and None not in position.values():
            yield number, rapid, (position["X"], position["Z"], math.radians(position["C"]))


def without_axis_words(line):
    return " ".join(re.sub(r"\b[XZC][-+]?[\d.]+", "", line).split())


def largest_distance(grinder, original, corrected):
    """Over all cuts: block ends, and the middles of blocks, where both programs are halfway."""
    worst_end = worst_middle = 0.0
    for index, ((_, rapid, wanted), (_, _, given)) in enumerate(zip(original, corrected)):
        if rapid:
            continue
        worst_end = max(worst_end, math.dist(grinder.point(given), grinder.point(wanted, ideal=True)))
        if index % 5 == 0 and index > 0:
            halves = [[(a + b) / 2 for a, b in zip(one[index - 1][2], one[index][2])] for one in (original, corrected)]
            worst_middle = max(worst_middle,
                               math.dist(grinder.point(halves[1]), grinder.point(halves[0], ideal=True)))
    return worst_end, worst_middle


def mean_errors(grinder, turns=10, radius=24.0):
    """The published case: ten turns at the final depth, every 15 degrees."""
    pitch = 1.5
    x = (2 * radius - 17 / 12 * math.sqrt(3) / 2 * pitch) / 2
    errors = [grinder.axis_errors((x, -pitch * k / 24, k * math.pi / 12)) for k in range(24 * turns + 1)]
    x, z, c = (sum(column) / len(errors) for column in zip(*errors))
    return {"X": x, "Z": z, "C": radius * c}


def main():
    faults = []

    def claim(holds, text):
        print(("ok   " if holds else "FAIL ") + text)
        if not holds:
            faults.append(text)

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "demo"
        done = subprocess.run([sys.argv[1], "demo", "--out", str(folder), "--json"], capture_output=True, text=True, timeout=300)
        claim(done.returncode == 0, f"demo ends with status {done.returncode} {done.stderr[:300]}")
        record = json.loads(done.stdout)
        grinder = Grinder(json.loads((folder / "model.json").read_text()))
        texts = [(folder / name).read_text() for name in ("thread.nc", "corrected.nc")]
        original, corrected = (list(commands(text)) for text in texts)
        present = {path.name for path in folder.iterdir()}
        wanted = {"machine.json", "model.json", "thread.json", "thread.nc", "corrected.nc", "path-before.csv",
                  "path-after.csv", "report.json", "summary.txt", "error-x.svg", "error-z.svg", "error-c.svg"}
        claim(present == wanted, f"the folder holds what it should: {sorted(present ^ wanted)}")
    claim(len(original) == len(corrected) > 10000, f"{len(original)} and {len(corrected)} motions")
    claim([without_axis_words(line) for line in texts[0].splitlines()] ==
          [without_axis_words(line) for line in texts[1].splitlines()], "nothing but axis words changed")
    means = mean_errors(grinder)
    for axis, (published, near) in PUBLISHED.items():
        claim(abs(means[axis] - published) < near, f"mean error of {axis} is {means[axis]:.7f} mm, published {published}")
    before = max(math.dist(grinder.point(q), grinder.point(q, ideal=True)) for _, rapid, q in original[::7] if not rapid)
    claim(abs(before - 1e0 * record["compensate"]["before"]["norm"]["max"]) < 2e-3, f"largest deviation before {before:.6f} mm")
    at_ends, between = largest_distance(grinder, original, corrected)
    claim(at_ends < ROUNDING_MM, f"after, at block ends, at most {at_ends * 1e3:.3f} um: the rounding of the words")
    claim(between < TOLERANCE_MM, f"after, between them, at most {between * 1e3:.3f} um")
    claim(record["compensate"]["after"]["norm"]["max"] < TOLERANCE_MM, "the program's own figure is below the tolerance too")
    for axis in "XZ":
        fine = record["compensate_nanometre"]
        left = abs(fine["after"][axis]["mean"] / fine["before"][axis]["mean"])
        claim(left < 0.01, f"with words to 1 nm, {100 * left:.6f} % of the mean error of {axis} is left")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
