"""Writes the files of a case exactly by the contract: nineline-measurement/1, nineline-model/1."""

import json

import numpy as np


def _cell(value, digits):
    if not np.isfinite(value):
        return ""
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".") if digits else f"{value:.0f}"
    return "0" if text in ("-0", "") else text


def _joint_columns(machine, file, gives_speed):
    whole, columns = file.whole, []
    for letter, one in machine.joints.items():
        columns.append((f"{letter}_{one.unit}", whole.q[letter], 6))
    told = [letter for letter in machine.joints if whole.is_stepped or letter not in whole.moving]
    columns += [(f"approach_{letter}_1", whole.s[letter], 0) for letter in told]
    for letter in whole.moving:
        unit = machine.joints[letter].unit
        if whole.is_stepped or gives_speed:
            columns.append((f"v_{letter}_{unit}_min", whole.v[letter] * 60.0, 5))
        if gives_speed and not whole.is_stepped:
            columns.append((f"a_{letter}_{unit}_s2", whole.a[letter], 5))
    return columns


def _condition_columns(machine, file, faults, step):
    whole = file.whole
    columns = [("feed_mm_min", whole.feed, 1)]
    if machine.id == "b2-k3032":
        columns.append(("pass_1", whole.wheel_pass, 0))
    columns.append(("load_kg", whole.load, 1))
    for sensor, values in whole.temps.items():
        shown = faults.get((file.name, sensor), values)
        columns.append((f"temp_{sensor}_C", np.round(shown / step) * step, 4))
    columns += [(name, values, 3) for name, values in whole.columns.items() if name.endswith("_1")]
    return columns


def _head(file, declared):
    lines = ["#nineline-measurement: 1", f"#machine: {file.machine_id}", f"#instrument: {file.instrument}"]
    for key, value in file.head.items():
        lines.append(f"#{key}: {' '.join(f'{v:.10g}' for v in value) if isinstance(value, list) else value}")
    for unit in ("um", "arcsec"):
        used = any(name.endswith(unit) for name in file.readings)
        if used and declared.get(unit) is not None:
            lines.append(f"#repeatability_{unit}: {declared[unit]:.3g}")
    return lines


def write_measurement(path, machine, file, declared, faults=None, gives_speed=True, temperature_step=0.05):
    """One CSV; `file.readings` holds the reading columns, `faults` what a broken sensor shows instead."""
    columns = [("run", file.whole.run_index, 0), ("t_s", file.whole.t, 6)]
    columns += _joint_columns(machine, file, gives_speed)
    columns += _condition_columns(machine, file, faults or {}, temperature_step)
    columns += [(name, values, 6) for name, values in file.readings.items()]
    lines = _head(file, declared) + [",".join(name for name, _, _ in columns)]
    for i in range(file.whole.n):
        lines.append(",".join(_cell(float(values[i]), digits) for _, values, digits in columns))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def model_text(machine, tables, sigmas, location):
    """The model that the program starts from."""
    effects = [table.text(sigma) for table, sigma in zip(tables, sigmas)]
    for component, value in location.items():
        kind = "um" if component[0] in "XYZ" else "arcsec"
        effects.append({"effect": "location", "component": component, f"value_{kind}": round(value, 4)})
    return {"format": "nineline-model/1", "machine": machine.text, "effects": effects}


def write_json(path, record):
    path.write_text(json.dumps(record, indent=1, default=_plain) + "\n", encoding="utf-8")


def _plain(value):
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(type(value).__name__)
