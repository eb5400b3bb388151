"""Measurement artefacts: mistakes of one set-up, added to the readings of one file and to nothing else.

They must be named as such and never enter the machine's model.
"""

import numpy as np


def _lines(case):
    """Laser files over the whole travel: their axis is also seen by other set-ups, so a lonely error shows."""
    return [file for file in case.files if file.instrument == "laser-linear" and "laser-" in file.name]


def _from_start(file):
    q = file.whole.q[file.head["axis"]]
    return q - q[0]


def _cosine(case, file, sigmas):
    """A beam out of line with the travel: readings too short, by the square of the angle."""
    span = _from_start(file)
    k = 2.0 * sigmas * file.sigma["um"] / np.ptp(span)
    return "cosine", {"k": 1000.0 * k}, -k * span


def _datum(case, file, sigmas):
    """The target was touched: a step between two samples of one file."""
    rows = file.whole.n
    at = int(case.rng.uniform(0.3, 0.7) * rows)
    shift = float(case.rng.choice([-1, 1])) * 1.5 * sigmas * file.sigma["um"]
    return "datum_shift", {"shift": shift}, shift * (np.arange(rows) >= at)


def hide(case):
    """Draws one artefact; (record for truth.json, file name, what it adds to `dev_um`)."""
    choices = _lines(case)
    file = choices[int(case.rng.integers(len(choices)))]
    make = (_cosine, _datum, _datum)[int(case.rng.integers(3))]
    name, parameters, values = make(case, file, case.rng.uniform(5.0, 12.0))
    record = {"effect": name, "joint": file.head["axis"], "file": f"{file.name}.csv", "parameters": parameters}
    return record, file.name, values
