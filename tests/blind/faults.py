"""Data faults, made in the files after the measurement: a run's sign, a run's unit, two exchanged channels, a sensor
that stands still. Each says which file and rows it spoiled."""

import numpy as np


def _strong_files(case):
    """Files whose readings rise well over their noise, so that a fault can be seen at all; and the column."""
    found = []
    for file in case.files:
        for name, values in file.readings.items():
            shown = values[np.isfinite(values)]
            centred = shown - np.median(shown)
            if np.std(centred) > 5 * file.sigma_of(name) and file.whole.run_index.max() >= 2:
                found.append((file, name))
    return found


def _one_run(file, rng):
    index = int(rng.integers(1, file.whole.run_index.max() + 1))
    return file.whole.run_index == index


def _note(kind, file, rows):
    places = np.flatnonzero(rows)
    return {"kind": kind, "file": f"{file.name}.csv", "rows": [int(places[0]) + 1, int(places[-1]) + 1]}


def _sign(case, rng):
    file, name = _pick(_strong_files(case), rng)
    rows = _one_run(file, rng)
    file.readings[name][rows] *= -1
    return _note("sign", file, rows), {}


def _unit(case, rng):
    file, name = _pick(_strong_files(case), rng)
    rows = _one_run(file, rng)
    file.readings[name][rows] *= float(rng.choice([25.4, 1 / 25.4, 1000.0, 0.001]))
    return _note("unit", file, rows), {}


def _swap(case, rng):
    several = [file for file in case.files if "volume" in file.name and
               sum(name.endswith("_um") for name in file.readings) >= 2]
    file = several[int(rng.integers(len(several)))]
    first, second = [name for name in file.readings if name.endswith("_um")][:2]
    rows = _one_run(file, rng)
    kept = file.readings[first][rows].copy()
    file.readings[first][rows] = file.readings[second][rows]
    file.readings[second][rows] = kept
    return _note("swap", file, rows), {}


def _stuck(case, rng):
    longest = sorted(case.files, key=lambda file: -file.whole.n)[:4]
    file = _pick(longest, rng)
    sensor = str(rng.choice(["bed", "ambient", "front"]))
    values, n = file.whole.temps[sensor].copy(), file.whole.n
    start = int(rng.uniform(0.3, 0.6) * n)
    values[start:] = values[start]
    rows = np.arange(n) >= start
    return {**_note("stuck", file, rows), "sensor": sensor}, {(file.name, sensor): values}


def _pick(choices, rng):
    return choices[int(rng.integers(len(choices)))]


def spoil(case, rng):
    """Spoils one file; (what was done, temperature columns to write instead)."""
    kinds = [_stuck]
    if _strong_files(case):
        kinds += [_sign, _unit, _sign]
    if any("volume" in file.name and sum(n.endswith("_um") for n in file.readings) >= 2 for file in case.files):
        kinds.append(_swap)
    fault, columns = _pick(kinds, rng)(case, rng)
    return [fault], columns
