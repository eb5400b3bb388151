"""Posts a cut and reads the result back with other means: its own kinematics, and LinuxCNC's rs274.

Usage: check_post.py CLI
"""

import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

POINTS = 400
FEED_MM_MIN = 1500.0


def cl_points():
    for number in range(POINTS):
        turn = 0.03 * number
        lean = 0.45 + 0.2 * math.sin(0.41 * turn)
        axis = (math.sin(lean) * math.cos(turn), math.sin(lean) * math.sin(turn), math.cos(lean))
        yield tuple(round(60.0 * a - (40.0 if i == 2 else 0.0), 6) for i, a in enumerate(axis)), axis


def cl_text(points):
    lines = ["PARTNO CHECK", "LOADTL/2", "SPINDL/8000,RPM,CLW", "RAPID"]
    for number, (tip, axis) in enumerate(points):
        lines.append("GOTO/" + ",".join(f"{v:.6f}" for v in tip) + "," + ",".join(f"{v:.12f}" for v in axis))
        if number == 0:
            lines.append(f"FEDRAT/{FEED_MM_MIN},MMPM")
    return "\n".join(lines + ["FINI", ""])


def trunnion(a_deg, c_deg, x, y, z):
    """Tip and axis in the workpiece of trunnion-ac: the table turns by A about -x, then C about -z."""
    a, c = math.radians(a_deg), math.radians(c_deg)

    def back(v):
        x1, y1, z1 = v[0], math.cos(a) * v[1] - math.sin(a) * v[2], math.sin(a) * v[1] + math.cos(a) * v[2]
        return math.cos(c) * x1 - math.sin(c) * y1, math.sin(c) * x1 + math.cos(c) * y1, z1

    return back((x, y, z)), back((0.0, 0.0, 1.0))


def distance(p, q):
    return math.dist(p, q)


def post(cli, folder, *options):
    arguments = [cli, "post", "--machine", "trunnion-ac", "cut.cls", "--out", "cut.nc", "--axes", "axes.csv",
                 "--json", *options]
    done = subprocess.run(arguments, cwd=folder, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    with open(folder / "axes.csv", encoding="utf-8", newline="") as rows:
        return json.loads(done.stdout), list(csv.DictReader(rows))


def check_axes(points, record, rows):
    reached = [row for row in rows if row["goto_1"] == "1"]
    assert len(reached) == len(points) == record["points"]
    for row, (tip, axis) in zip(reached, points):
        pose = trunnion(*(float(row[name]) for name in ("A_deg", "C_deg", "X_mm", "Y_mm", "Z_mm")))
        assert distance(pose[0], tip) < 1e-8, (row, tip)
        assert distance(pose[1], axis) < 1e-9, (row, axis)
    assert record["max_residual_mm"] < 1e-9 and record["branch_switches"] == 0


def rs274_moves(folder):
    done = subprocess.run(["rs274", "-g", "cut.nc"], cwd=folder, capture_output=True, text=True, timeout=120)
    moves, feed = [], None
    for line in done.stdout.splitlines():
        if found := re.search(r"SET_FEED_RATE\(([^)]*)\)", line):
            feed = float(found[1])
        if found := re.search(r"(STRAIGHT_FEED|STRAIGHT_TRAVERSE)\(([^)]*)\)", line):
            x, y, z, a, _, c = (float(v) for v in found[2].split(","))
            moves.append((found[1] == "STRAIGHT_FEED", feed, (a, c, x, y, z)))
    return moves


def check_rs274(folder, rows):
    moves = rs274_moves(folder)
    assert len(moves) == len(rows), (len(moves), len(rows))
    before = None
    for (is_feed, feed, q), row in zip(moves, rows):
        wanted = trunnion(*(float(row[name]) for name in ("A_deg", "C_deg", "X_mm", "Y_mm", "Z_mm")))
        pose = trunnion(*q)
        assert distance(pose[0], wanted[0]) < 3e-4, (q, row)  # rs274 prints four decimals
        assert is_feed == (row["rapid_1"] == "0")
        if is_feed and before:  # F counts the linear axes' way
            seconds = distance(q[2:], before[2:]) / feed * 60.0
            speed = distance(pose[0], trunnion(*before)[0]) / seconds * 60.0
            assert abs(speed - FEED_MM_MIN) < 0.02 * FEED_MM_MIN, (speed, row)
        before = q


def main():
    cli = str(pathlib.Path(sys.argv[1]).resolve())
    points = list(cl_points())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "cut.cls").write_text(cl_text(points), encoding="utf-8")
        for control in ("fanuc", "siemens", "heidenhain", "linuxcnc"):
            record, rows = post(cli, folder, "--control", control)
            check_axes(points, record, rows)
        if shutil.which("rs274") is None:
            print("rs274 is not there: the LinuxCNC program was not read back")
        else:
            check_rs274(folder, rows)
    print("post: every point is reached")
    return 0


if __name__ == "__main__":
    sys.exit(main())
