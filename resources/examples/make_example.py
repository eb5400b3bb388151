#!/usr/bin/env python3
"""Writes b2-k3032-model.json: the worked example, a B2-K3032 thread grinder and its errors.

The machine's errors were published only as mean values: X -0.096 mm, Z 0.157 mm, C 0.004 mm of arc at the outside
diameter, over a left-hand thread M48x1.5 of 15 mm. The curves below are made so that a simulation of that thread
(x = 23.07985 mm, z from 0 to -15 mm, ten turns) shows just these means. They are our own, not anyone's measurement.

Notation: s = x - 24 mm, u = -z / 15 mm, c = 2u - 1, g = the angle of C; EXX and so on are the errors of ISO 230-1,
in mm and rad, in the frame that moves with the joint. The geometry of the machine: work spindle at q2 = (0, 0, 300) in the
table, wheel slide at q4 = (200, 0, 300), grinding point at t = (-200, 0, 0) in the slide.
Usage: make_example.py [FILE]; without FILE the model is written beside this script.
"""

import json
import math
import pathlib
import sys

TURN = 2.0 * math.pi
ARCSEC = 648000.0 / math.pi
RADIUS_MM = 24.0
LENGTH_MM = 15.0

X_ERRORS = {
    "EXX": lambda s: -0.040317208 + 1e-4 * s,
    "EYX": lambda s: -0.002518639 + 2e-5 * s,
    "EZX": lambda s: -0.0247 - 3e-5 * s,
    "EAX": lambda s: 1e-5,
    "EBX": lambda s: -0.000267231,
    "ECX": lambda s: -5e-6,
}

Z_ERRORS = {
    "EXZ": lambda u: 0.024 + 0.004 * (2 * u - 1) + 0.0015 * math.sin(TURN * u),
    "EYZ": lambda u: 0.0008 * (2 * u - 1),
    "EZZ": lambda u: 0.079958818 + 0.012 * (2 * u - 1) + 0.002 * math.sin(2 * TURN * u),
    "EAZ": lambda u: -7.711e-6 + 1e-6 * (2 * u - 1),
    "EBZ": lambda u: 0.000104099 + 4e-6 * (2 * u - 1),
    "ECZ": lambda u: 3e-6 * math.sin(TURN * u),
}

C_ERRORS = {
    "EXC": lambda g: 0.0015 * math.cos(2 * g),
    "EYC": lambda g: 0.0010 * math.sin(g),
    "EZC": lambda g: 0.0012 * math.sin(g),
    "EAC": lambda g: 8e-6 * math.cos(g),
    "EBC": lambda g: 6e-6 * math.sin(2 * g),
    "ECC": lambda g: 2.5e-5 * math.sin(2 * g),
}

# C is not quite parallel to Z, X not quite square to it.
LOCATIONS = {"A0C": 6e-6, "B0C": 12e-6, "B0X": -9e-6}

MACHINE = {
    "format": "nineline-machine/1",
    "id": "b2-k3032-example",
    "name": "B2-K3032 thread grinder (worked example)",
    "workpiece_chain": [
        {"axis": "Z", "type": "linear", "direction": [0, 0, 1], "offset_mm": [0, 0, 0], "travel": [-400, 400],
         "rapid_mm_min": 6000},
        {"axis": "C", "type": "rotary", "direction": [0, 0, 1], "offset_mm": [0, 0, 300], "continuous": True,
         "rapid_deg_min": 14400},
    ],
    "tool_chain": [
        {"axis": "X", "type": "linear", "direction": [1, 0, 0], "offset_mm": [200, 0, 300], "travel": [-50, 350],
         "rapid_mm_min": 6000},
    ],
    "tool": {"tip_mm": [-200, 0, 0], "axis": [0, 0, 1]},
}


def shown(component, value):
    """An error as the file shows it: um, or arcsec for an angular one; never -0."""
    return round(value * ARCSEC if component[1] in "ABC" else value * 1e3, 6) + 0.0


def table(joint, component, unit, start, spacing, values):
    key = "values_arcsec" if component[1] in "ABC" else "values_um"
    return {"effect": "table", "joint": joint, "component": component, f"start_{unit}": start,
            f"spacing_{unit}": spacing, key: [shown(component, value) for value in values],
            "interpolation": "cubic", "source": "measured"}


def effects():
    for component, error in X_ERRORS.items():  # straight lines: a coarse grid is exact
        positions = [-10.0 + 10.0 * k for k in range(9)]
        yield table("X", component, "mm", -10, 10, [error(x - RADIUS_MM) for x in positions])
    for component, error in Z_ERRORS.items():  # twice the thread's length on both sides of its middle
        positions = [-30.0 + 1.25 * k for k in range(49)]
        yield table("Z", component, "mm", -30, 1.25, [error(-z / LENGTH_MM) for z in positions])
    for component, error in C_ERRORS.items():  # one turn; C is continuous, so its tables are periodic
        angles = [math.radians(15.0 * k) for k in range(24)]
        yield table("C", component, "deg", 0, 15, [error(g) for g in angles])
    for component, value in LOCATIONS.items():
        yield {"effect": "location", "component": component, "value_arcsec": round(value * ARCSEC, 9),
               "source": "measured"}


def machine_lines():
    """The machine, a joint on each line."""
    for key, value in MACHINE.items():
        if key.endswith("_chain"):
            joints = ",\n".join("   " + json.dumps(joint) for joint in value)
            yield f"  {json.dumps(key)}: [\n{joints}\n  ]"
        else:
            yield f"  {json.dumps(key)}: {json.dumps(value)}"


def main():
    here = pathlib.Path(__file__).resolve().parent
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here / "b2-k3032-model.json"
    machine = "{\n" + ",\n".join(machine_lines()) + "\n }"
    lines = ",\n".join("  " + json.dumps(effect) for effect in effects())
    target.write_text('{\n "format": "nineline-model/1",\n "machine": ' + machine + ',\n "effects": [\n' + lines +
                      "\n ]\n}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
