#!/usr/bin/env python3
"""Holds the program's forward model against the simulator's: the true model goes into a model file, `predict` must give
the noise-free readings.

python3 tests/blind/crosscheck.py --cli PATH [--seeds A:B] --out FOLDER

Prints, for every instrument (true tables and locations alone) and every effect (beside them, in the library's form),
the largest residual in um or arcsec. Anything above a few hundredths is a difference of convention.
"""

import argparse
import csv
import pathlib
import shutil

import cases
import effects
import files
import hidden
import readings
import runner


def _true_model(case, found):
    model = files.model_text(case.machine, case.tables, [None] * len(case.tables), case.location)
    for text, table in zip(model["effects"], case.tables):
        values = "values_arcsec" if table.component[1] in "ABC" else "values_um"
        text[values] = [float(v) for v in table.values]
    for text in model["effects"]:
        for key, name in (("value_um", text.get("component")), ("value_arcsec", text.get("component"))):
            if key in text:
                text[key] = case.location[name]
    model["effects"] += [{**one, "parameters": {name: {"value": value} for name, value in one["parameters"].items()}}
                         for one in found]
    return model


def _exact(case, file, found):
    errors = cases.baseline_errors(case, file.whole)
    for one in found:
        for component, standing, values in effects.contribution(case.machine, one, file.whole):
            errors.add(component, values, standing)
    return readings.read(case.machine, file, file.whole, errors)


def _largest(cli, case, folder, found):
    """{instrument: largest residual} of a model with those effects."""
    files.write_json(folder / "true.json", _true_model(case, found))
    worst = {}
    for file in case.fresh:
        file.readings, file.machine_id = _exact(case, file, found), case.machine.id
        path, out = folder / f"{file.name}.csv", folder / "predicted.csv"
        files.write_measurement(path, case.machine, file, {"um": 0.1, "arcsec": 0.1}, temperature_step=0.0005)
        runner.run(cli, "--quiet", "predict", "--model", folder / "true.json", path, "--out", out)
        worst[file.instrument] = max(worst.get(file.instrument, 0.0), _worst_residual(out))
    return worst


def _worst_residual(path):
    with open(path, encoding="utf-8") as stream:
        rows = list(csv.reader(line for line in stream if not line.startswith("#")))
    places = [k for k, name in enumerate(rows[0]) if name.startswith("residual_")]
    return max((abs(float(row[k])) for row in rows[1:] for k in places if row[k]), default=0.0)


def _every_effect(case):
    """One of each effect that this machine can have, a few um or arcsec large."""
    for name, drawer in hidden.DRAWERS.items():
        effect = drawer(case.machine, case.rng)
        if effect is None:
            continue
        effect["parameters"][hidden.size_key(effect)] = 1.0
        unit = cases.signature(case, effect, effects.contribution)
        largest = max(float(abs(one).max()) for one in unit)
        if largest > 0:
            effect["parameters"][hidden.size_key(effect)] = 10.0 / largest
            yield name, effect


def check(cli, seed, folder):
    case = cases.draw(seed)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    plain = _largest(cli, case, folder, [])
    print(f"seed {seed} {case.machine.id}: " + ", ".join(f"{k} {v:.4f}" for k, v in plain.items()), flush=True)
    for name, effect in _every_effect(case):
        if effect["effect"] in hidden.MEMORY and not case.options.split_runs:
            continue
        try:
            worst = _largest(cli, case, folder, [effect])
        except runner.ProgramFailed as error:
            print(f"  {name}@{effect['joint']}: {error}", flush=True)
            continue
        away = {k: v for k, v in worst.items() if v > plain[k] + 0.02}
        told = ", ".join(f"{k} {v:.3f}" for k, v in away.items()) or "agrees"
        print(f"  {name}@{effect['joint']} {effect['component']}: {told}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cli", type=pathlib.Path, required=True)
    parser.add_argument("--seeds", default="1:6")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    options = parser.parse_args()
    first, last = (int(one) for one in options.seeds.split(":"))
    for seed in range(first, last):
        check(options.cli, seed, options.out)


if __name__ == "__main__":
    main()
