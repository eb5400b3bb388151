"""Deterministic inputs of the speed measurements: error models and NC programs of any length."""
import json
import math
import random

BLOCKS_A_TURN = 100_000


def write_model(path, machine, axes, seed=7):
    """Cubic tables of 64 nodes for all six components of every axis, a few location errors. `axes`: letters."""
    rng = random.Random(seed)
    effects = []
    for axis in axes:
        rotary = axis in "ABC"
        for row in "XYZABC":
            component = "E" + row + axis
            angular = row in "ABC"
            size = rng.uniform(1.0, 4.0) if angular else rng.uniform(4.0, 15.0)
            waves = [(rng.uniform(-size, size), n, rng.uniform(0, 2 * math.pi)) for n in (1, 2, 3)]
            values = [round(sum(a * math.sin(2 * math.pi * n * i / 64 + p) for a, n, p in waves) / 3, 4)
                      for i in range(64)]
            effect = {"effect": "table", "joint": axis, "component": component, "interpolation": "cubic"}
            if rotary:
                start, spacing = (0.0, 360.0 / 64) if axis == "C" else (-126.0, 4.0)
                effect |= {"start_deg": start, "spacing_deg": spacing}
            else:
                effect |= {"start_mm": -504.0, "spacing_mm": 16.0}
            effect["values_arcsec" if angular else "values_um"] = values
            effects.append(effect)
    effects.append({"effect": "location", "component": "C0Y" if "Y" in axes else "B0Z", "value_arcsec": 6.0})
    with open(path, "w") as out:
        json.dump({"format": "nineline-model/1", "machine": machine, "effects": effects}, out)


def lines_of_turn(five):
    """One closed turn of the path: short feed blocks, about 0.2 mm each."""
    step = 2 * math.pi / BLOCKS_A_TURN
    for i in range(BLOCKS_A_TURN):
        t = step * i
        r = 100 + 60 * math.sin(23 * t)
        x, y, z = r * math.cos(17 * t), r * math.sin(17 * t), -40 + 30 * math.sin(5 * t)
        if five:
            a, c = 35 + 20 * math.sin(3 * t), 170 * math.sin(2 * t)
            yield f"G1 X{x:.4f} Y{y:.4f} Z{z:.4f} A{a:.4f} C{c:.4f}\n"
        else:
            yield f"X{x:.3f} Y{y:.3f} Z{z:.3f}\n"


def write_program(path, blocks, five):
    """`blocks` feed blocks between a short head and end, in words that `rs274` reads too."""
    turn = list(lines_of_turn(five))
    text = "".join(turn)
    with open(path, "w") as out:
        out.write("G21 G90 G17 G94 G54\nG0 X160 Y0 Z-40" + (" A35 C0" if five else "") + "\nG1 F1200\n")
        for _ in range(blocks // BLOCKS_A_TURN):
            out.write(text)
        out.write("".join(turn[: blocks % BLOCKS_A_TURN]))
        out.write("M2\n")
