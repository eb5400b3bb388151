"""Noise-free readings of the contract's instruments, from exact kinematics."""

import numpy as np

import machines
from machines import ARCSEC, UM

BED = {"X": 0, "Y": 1, "Z": 2}


def _bed_point(machine, point):
    """A point given in W with all joints at zero, in the bed."""
    zero = {letter: np.zeros(1) for letter in machine.joints}
    work = machines.bodies(machine, zero, machines.ErrorState(1))["W"]
    return machines.apply(work, np.array([point], float))[0], zero


def _on_body(machine, letter, point):
    """The same point in the frame of the body that the joint moves."""
    in_bed, zero = _bed_point(machine, point)
    body = machines.bodies(machine, zero, machines.ErrorState(1))[letter]
    return machines.apply(machines.inverse(body), in_bed[None, :])[0]


def _relative(machine, q, errors):
    ideal = machines.tool_in_work(machine, machines.bodies(machine, q, machines.ErrorState(errors.n)))
    actual = machines.tool_in_work(machine, machines.bodies(machine, q, errors))
    return ideal, actual


def deviation(machine, file, whole, errors):
    ideal, actual = _relative(machine, whole.q, errors)
    shift = (actual[1] - ideal[1]) / UM
    turn = machines.rotation_vectors(actual[0][0] @ np.swapaxes(ideal[0][0], 1, 2)) / ARCSEC
    every = {f"dev_{k}_um": shift[:, i] for i, k in enumerate("xyz")}
    every.update({f"rot_{k}_arcsec": turn[:, i] for i, k in enumerate("xyz")})
    return {name: every[name] for name in file.channels}


def joint(machine, file, whole, errors):
    one = machine.joints[file.head["axis"]]
    slot = machines.COMPONENT_SLOT[one.positioning[1]]
    total = np.zeros(errors.n)
    for place in (errors.moved, errors.standing):
        if one.letter in place:
            total = total + place[one.letter][:, slot]
    return {"dev_um": total / UM} if one.linear else {"dev_arcsec": total / ARCSEC}


def _moving_point(machine, file, whole, errors):
    letter = file.head["axis"]
    local = _on_body(machine, letter, file.head["point_mm"])
    ideal = machines.bodies(machine, whole.q, machines.ErrorState(errors.n))[letter]
    actual = machines.bodies(machine, whole.q, errors)[letter]
    return (machines.apply(actual, local) - machines.apply(ideal, local)) / UM


def laser_linear(machine, file, whole, errors):
    moved = _moving_point(machine, file, whole, errors)
    return {"dev_um": moved @ machine.joints[file.head["axis"]].direction}


def laser_straightness(machine, file, whole, errors):
    return {"dev_um": _moving_point(machine, file, whole, errors)[:, BED[file.head["sensitive"]]]}


def laser_angular(machine, file, whole, errors):
    letter = file.head["axis"]
    ideal = machines.bodies(machine, whole.q, machines.ErrorState(errors.n))[letter]
    actual = machines.bodies(machine, whole.q, errors)[letter]
    turn = machines.rotation_vectors(actual[0] @ np.swapaxes(ideal[0], 1, 2))
    return {"dev_arcsec": turn[:, BED[file.head["about"]]] / ARCSEC}


def ballbar(machine, file, whole, errors):
    _, actual = _relative(machine, whole.q, errors)
    radius = np.linalg.norm(actual[1] - np.array(file.head["centre_mm"], float), axis=1)
    return {"dr_um": (radius - file.head["radius_mm"]) / UM}


def lead(machine, file, whole, errors):
    ideal, actual = _relative(machine, whole.q, errors)
    per_turn = file.head["pitch_mm"] * file.head["starts"] * (-1 if file.head["hand"] == "left" else 1)
    p, r = actual[1], ideal[1]
    turned = np.arctan2(r[:, 0] * p[:, 1] - r[:, 1] * p[:, 0], r[:, 0] * p[:, 0] + r[:, 1] * p[:, 1])
    return {"dev_um": (p[:, 2] - r[:, 2] - per_turn / (2 * np.pi) * turned) / UM}


def dial(machine, file, whole, errors):
    letter, (point, _) = file.head["axis"], _bed_point(machine, file.head["point_mm"])
    ideal = machines.bodies(machine, whole.q, machines.ErrorState(errors.n))[letter]
    actual = machines.bodies(machine, whole.q, errors)[letter]
    moved = machines.apply(machines.compose(actual, machines.inverse(ideal)), point) - point
    return {"dev_um": moved[:, BED[file.head["sensitive"]]] / UM}


READERS = {"deviation": deviation, "joint": joint, "laser-linear": laser_linear, "ballbar": ballbar, "lead": lead,
           "laser-straightness": laser_straightness, "laser-angular": laser_angular, "dial": dial}
HAS_ZERO = {"joint", "laser-linear", "laser-straightness", "laser-angular", "lead", "dial"}


def read(machine, file, whole, errors):
    """Noise-free readings of a file: column name to values."""
    return READERS[file.instrument](machine, file, whole, errors)
