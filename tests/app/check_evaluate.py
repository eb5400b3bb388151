#!/usr/bin/env python3
"""A second opinion on `evaluate --json`: the golden cases' files, computed again from the definitions with nothing but
the standard library. Usage: check_evaluate.py CLI SOURCE_DIR"""

import csv
import json
import math
import pathlib
import statistics
import subprocess
import sys

TOLERANCE_UM = 1e-6


def rows_of(path):
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


def evaluated(cli, path):
    done = subprocess.run([cli, "evaluate", str(path), "--json", "--quiet"], capture_output=True, check=True)
    return json.loads(done.stdout)


def positioning(path):
    """ISO 230-2 and VDI 3441 of a file whose runs go up, then down, with every target twice."""
    sides = {}
    for run in {row["run"] for row in rows_of(path)}:
        rows = [row for row in rows_of(path) if row["run"] == run]
        for number, row in enumerate(rows):
            sides.setdefault((float(row["X_mm"]), number < len(rows) // 2), []).append(float(row["dev_um"]))
    targets = sorted({target for target, _ in sides})
    mean = {key: statistics.fmean(values) for key, values in sides.items()}
    s = {key: statistics.stdev(values) for key, values in sides.items()}
    both = [0.5 * (mean[t, True] + mean[t, False]) for t in targets]
    B = [mean[t, True] - mean[t, False] for t in targets]
    R = [max(2 * s[t, True] + 2 * s[t, False] + abs(b), 4 * s[t, True], 4 * s[t, False]) for t, b in zip(targets, B)]

    def spread(keys, k):
        return max(mean[key] + k * s[key] for key in keys) - min(mean[key] - k * s[key] for key in keys)

    up, down = [(t, True) for t in targets], [(t, False) for t in targets]
    half = [0.5 * (abs(b) + 3 * (s[t, True] + s[t, False])) for t, b in zip(targets, B)]
    return {
        "iso_230_2": {
            "A_um": spread(up + down, 2), "A_forward_um": spread(up, 2), "A_backward_um": spread(down, 2),
            "E_um": spread(up + down, 0), "E_forward_um": spread(up, 0), "E_backward_um": spread(down, 0),
            "R_um": max(R), "R_forward_um": max(4 * s[k] for k in up), "R_backward_um": max(4 * s[k] for k in down),
            "M_um": max(both) - min(both), "B_um": max(map(abs, B)), "mean_B_um": statistics.fmean(B)},
        "vdi_3441": {
            "P_um": max(x + h for x, h in zip(both, half)) - min(x - h for x, h in zip(both, half)),
            "Pa_um": max(both) - min(both), "U_max_um": max(map(abs, B)), "U_mean_um": statistics.fmean(map(abs, B)),
            "Ps_max_um": max(3 * (s[t, True] + s[t, False]) for t in targets)}}


def circle_through(points):
    """Centre and radius: least squares of distances, by descent on the two partial derivatives."""
    u = v = 0.0
    for _ in range(200):
        radius = statistics.fmean(math.hypot(x - u, y - v) for x, y in points)
        du = statistics.fmean((x - u) * (1 - radius / math.hypot(x - u, y - v)) for x, y in points)
        dv = statistics.fmean((y - v) * (1 - radius / math.hypot(x - u, y - v)) for x, y in points)
        u, v = u + 2 * du, v + 2 * dv
    return u, v, statistics.fmean(math.hypot(x - u, y - v) for x, y in points)


def circular(path, radius=150.0):
    paths = {}
    for row in rows_of(path):
        angle = math.atan2(float(row["Y_mm"]), float(row["X_mm"]))
        length = radius + 1e-3 * float(row["dr_um"])
        paths.setdefault(row["run"], []).append((length * math.cos(angle), length * math.sin(angle)))

    def distances(points, centre):
        return [math.hypot(x - centre[0], y - centre[1]) for x, y in points]

    def range_um(points):
        found = distances(points, circle_through(points))
        return 1e3 * (max(found) - min(found))

    ccw, cw = paths["1"], paths["2"]
    centre = circle_through(ccw + cw)
    all_of_them = distances(ccw + cw, centre)
    return {"iso_230_4": {
        "G_um": 1e3 * (max(all_of_them) - min(all_of_them)), "G_ccw_um": range_um(ccw), "G_cw_um": range_um(cw),
        "F_max_um": 1e3 * (max(all_of_them) - radius), "F_min_um": 1e3 * (min(all_of_them) - radius),
        "D_um": 1e3 * (centre[2] - radius)}}


def main():
    cli, cases = sys.argv[1], pathlib.Path(sys.argv[2]) / "tests/app/evaluate"
    faults = 0
    for path, expected in ((cases / "laser-json/x-axis.csv", positioning), (cases / "ballbar-json/circle.csv", circular)):
        found = evaluated(cli, path)
        for standard, figures in expected(path).items():
            for key, value in figures.items():
                if abs(found[standard][key] - value) > TOLERANCE_UM:
                    print(f"{path.name}: {standard}.{key} is {found[standard][key]}, computed here {value}")
                    faults += 1
                else:
                    print(f"{path.name}: {standard}.{key} {value:.6f} um agrees")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
