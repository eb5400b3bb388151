"""Holds one answer of `discover` against the truth of its case."""

import csv
import math
import pathlib

NAMED_FROM, SURE_FROM = 0.5, 0.9


def named_effects(answer):
    """Effects that count as named (contract, convention 13); a smooth correction is no name."""
    return [one for one in answer.get("effects", []) if one.get("effect") != "nonparametric"
            and one.get("confidence", 0.0) >= NAMED_FROM]


def _matches(named, hidden):
    return any(named.get("effect") == same["effect"] and named.get("joint") == same["joint"]
               for same in hidden.get("equivalents", []))


def _labels(named):
    return [f"{one.get('effect')}@{one.get('joint')}" for one in named]


def _file_of(note):
    return pathlib.Path(str(note.get("file", ""))).name


def pair_up(named, hidden):
    """[(hidden, named or None)] and the names that belong to nothing hidden."""
    left, pairs = list(named), []
    for one in hidden:
        fitting = [name for name in left if _matches(name, one)]
        fitting.sort(key=lambda name: name.get("component") != one["component"])
        pairs.append((one, fitting[0] if fitting else None))
        if fitting:
            left.remove(fitting[0])
    return pairs, left


# --- parameters

def _number(parameter):
    value = parameter.get("value") if isinstance(parameter, dict) else parameter
    return float(value) if isinstance(value, (int, float)) else None


def _turned(value):
    """An angle in degrees, to -180…180."""
    return (value + 180.0) % 360.0 - 180.0


def parameter_errors(hidden, named):
    """{parameter: error in units of the stated sigma, or None where no sigma is stated}."""
    stated, found = named.get("parameters", {}), {}
    key = hidden["size_parameter"]
    if named["effect"] != hidden["effect"] or key not in stated:
        return {}
    truth, size = hidden["equivalent_value"], _number(stated[key])
    if size is None:
        return {key: None}
    phase = hidden["parameters"].get("phase")
    if hidden["sign_free"] or phase is not None:
        flip, truth, size = (truth < 0) != (size < 0), abs(truth), abs(size)
    found[key] = _in_sigmas(size - truth, stated[key])
    if "bend" in hidden:
        return found
    for name, value in hidden["parameters"].items():
        if name in (key, "n") or name not in stated or not isinstance(value, (int, float)):
            continue
        error = (_number(stated[name]) or 0.0) - value
        if name == "phase":
            error = _turned(error + (180.0 if flip else 0.0))
        found[name] = _in_sigmas(error, stated[name])
    return found


def _in_sigmas(error, parameter):
    sigma = parameter.get("sigma") if isinstance(parameter, dict) else None
    if not isinstance(sigma, (int, float)) or not math.isfinite(sigma) or sigma < 0:
        return None
    return abs(error) / sigma if sigma > 0 else (0.0 if error == 0 else math.inf)


# --- what the names are worth

def judge_names(truth, answer):
    hidden = [one for one in truth["hidden"] if one["effect"] != "unknown"]
    named = named_effects(answer)
    pairs, false = pair_up(named, hidden)
    errors = [parameter_errors(one, name) for one, name in pairs if name is not None]
    sure_right = [name for _, name in pairs if name is not None and name.get("confidence", 0) >= SURE_FROM]
    sure_false = [name for name in false if name.get("confidence", 0) >= SURE_FROM]
    if not truth["separable"]:
        sure_false, sure_right = sure_false + sure_right, []
    return {"names": _labels(named), "missed": _labels(one for one, name in pairs if name is None),
            "false_names": _labels(false),
            "named_right": sum(name is not None for _, name in pairs), "hidden": len(hidden),
            "exact_set": not false and all(name is not None for _, name in pairs),
            "sure_right": len(sure_right), "sure_false": len(sure_false), "parameter_errors": errors}


def lists_lookalike(truth, answer):
    """Whether an effect of the undecidable group is named (or suspected) with another of the group beside it, and
    the hidden one is among them; being sure of one of them is claiming."""
    group = {(one["effect"], one["joint"]) for one in truth["lookalike_group"]}
    hidden = (truth["lookalike_group"][0]["effect"], truth["lookalike_group"][0]["joint"])
    for one in answer.get("effects", []):
        said = {(one.get("effect"), one.get("joint"))}
        said |= {(like.get("effect"), like.get("joint")) for like in one.get("lookalikes", [])}
        if hidden in said and len(said & group) >= 2 and one.get("confidence", 1.0) < SURE_FROM:
            return True
    return False


def finds_fault(fault, answer):
    """Whether `data_quality` points at the spoiled file and at some of its spoiled rows."""
    first, last = fault["rows"]
    for note in answer.get("data_quality", []):
        rows = note.get("rows") or [1, 10**9]
        same_file = _file_of(note) == fault["file"]
        if same_file and rows[0] <= last and rows[-1] >= first:
            return True
    return False


def judge_artefact(artefact, answer):
    """Whether the artefact has its name, or at least a note on its file; whatever else is named is false."""
    named = [one for one in named_effects(answer) if one.get("effect") == artefact["effect"]]
    others = [one for one in named_effects(answer) if one.get("effect") != artefact["effect"]]
    noted = any(_file_of(note) == artefact["file"] for note in answer.get("data_quality", []))
    return {"artefact": artefact["effect"], "artefact_named": bool(named), "artefact_noted": bool(named) or noted,
            "false_names": _labels(others), "names": _labels(named_effects(answer))}


def points_at_joint(truth, answer):
    """Whether `where` speaks of the position of a joint with a hidden effect; None where nothing is hidden."""
    if not truth["hidden"]:
        return None
    variables = {condition.get("variable", "") for place in answer.get("where", [])
                 for condition in place.get("conditions", [])}
    return any(f"{one['joint']}_{unit}" in variables for one in truth["hidden"] for unit in ("mm", "deg"))


# --- fresh data

def squares(predicted_csv, sigma):
    """Sum of squared residuals in sigmas, and their number, of one file written by `predict`."""
    total, count = 0.0, 0
    with open(predicted_csv, encoding="utf-8") as stream:
        rows = csv.reader(line for line in stream if not line.startswith("#"))
        names = next(rows)
        places = [(k, sigma["arcsec" if name.endswith("arcsec") else "um"])
                  for k, name in enumerate(names) if name.startswith("residual_")]
        for row in rows:
            for k, unit in places:
                if row[k]:
                    total += (float(row[k]) / unit) ** 2
                    count += 1
    return total, count


def closed_pct(before, after):
    """The contract's formula on data without noise."""
    return 100.0 * (before - after) / before if before > 0 else None
