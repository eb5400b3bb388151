#!/usr/bin/env python3
"""Makes the readings of the model-gap example: the worked example's machine, on which the Z screw grows with its
temperature and the X axis has play that the model does not know.

    python3 resources/examples/make_gap_example.py path/to/nineline-cli

The readings are those that `predict` gives for the true machine, plus seeded noise. Writes the files beside itself.
"""

import csv
import io
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SIGMA_UM = 0.4
HIDDEN = [
    {"effect": "thermal_screw", "joint": "Z", "component": "EZZ",
     "parameters": {"k": {"value": 10.5, "unit": "um/m/C"}, "q_fixed": {"value": -150.0, "unit": "mm"},
                    "sensor": "temp_screw_Z_C"}},
    {"effect": "backlash", "joint": "X", "parameters": {"width": {"value": 3.2, "unit": "um"}}}]


def there_and_back(low, high, step):
    places = [low + step * i for i in range(round((high - low) / step) + 1)]
    return places + places[::-1]


def laser_z(noise):
    rows = []
    for run, warm in enumerate([0.4, 2.9, 5.6, 8.3], start=1):
        for n, z in enumerate(there_and_back(-30, 30, 5)):
            t = 3600.0 * (run - 1) + 8.0 * n
            rows.append({"run": run, "t_s": t, "Z_mm": z, "temp_screw_Z_C": round(20 + warm + noise.gauss(0, 0.05), 2),
                         "temp_bed_C": round(20 + 0.2 * warm + noise.gauss(0, 0.05), 2), "dev_um": ""})
    return {"instrument": "laser-linear", "axis": "Z", "point_mm": "0 0 0"}, rows


def laser_x(noise):
    rows = []
    for run in range(1, 5):
        for n, x in enumerate(there_and_back(-10, 70, 10)):
            t = 20000.0 + 1200.0 * run + 8.0 * n
            warm = 1.0 + 0.8 * run
            rows.append({"run": run, "t_s": t, "X_mm": x, "temp_screw_Z_C": round(20 + warm + noise.gauss(0, 0.05), 2),
                         "temp_bed_C": round(20 + 0.2 * warm + noise.gauss(0, 0.05), 2), "dev_um": ""})
    return {"instrument": "laser-linear", "axis": "X", "point_mm": "0 0 0"}, rows


def lead(noise):
    rows = []
    for run, warm in enumerate([1.1, 4.2, 7.8], start=1):
        for n in range(41):
            z = -15.0 * n / 40
            rows.append({"run": run, "t_s": 40000.0 + 2400.0 * run + 2.0 * n, "X_mm": 23.08, "Z_mm": z,
                         "C_deg": round(-360.0 * z / 1.5, 6),
                         "temp_screw_Z_C": round(20 + warm + noise.gauss(0, 0.05), 2),
                         "temp_bed_C": round(20 + 0.2 * warm + noise.gauss(0, 0.05), 2), "dev_um": ""})
    return {"instrument": "lead", "pitch_mm": "1.5", "starts": "1", "hand": "left"}, rows


def text_of(head, rows):
    out = io.StringIO()
    lines = {"nineline-measurement": "1", "machine": "b2-k3032", **head, "repeatability_um": SIGMA_UM}
    out.writelines(f"#{key}: {value}\n" for key, value in lines.items())
    writer = csv.DictWriter(out, fieldnames=list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return out.getvalue()


def predicted(cli, model, text):
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder) / "in.csv", Path(folder) / "out.csv"
        source.write_text(text, encoding="utf-8")
        subprocess.run([cli, "predict", "--model", str(model), str(source), "--out", str(target), "--quiet"], check=True)
        lines = [line for line in target.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return [float(row["pred_dev_um"]) for row in csv.DictReader(lines)]


def main():
    cli = sys.argv[1]
    noise = random.Random(3032)
    truth = json.loads((HERE / "b2-k3032-model.json").read_text(encoding="utf-8"))
    truth["effects"] += HIDDEN
    with tempfile.TemporaryDirectory() as folder:
        model = Path(folder) / "truth.json"
        model.write_text(json.dumps(truth), encoding="utf-8")
        for name, make in [("gap-laser-z.csv", laser_z), ("gap-laser-x.csv", laser_x), ("gap-lead.csv", lead)]:
            head, rows = make(noise)
            zero = noise.gauss(0, 20)
            for row, value in zip(rows, predicted(cli, model, text_of(head, rows))):
                row["dev_um"] = round(value + zero + noise.gauss(0, SIGMA_UM), 2)
            (HERE / name).write_text(text_of(head, rows), encoding="utf-8")


if __name__ == "__main__":
    main()
