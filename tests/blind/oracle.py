"""Stand-ins for nineline-cli inside the process, for the trial's own tests and to know which figures are within reach.

`oracle` reads truth.json beside the model and names what is hidden, with the library's formulas; `nothing` never finds
anything. Neither corrects the noisy tables of the model.
"""

import json
import pathlib

import numpy as np

import cases
import effects
import files
import machines
import readings
import tables


def _truth(model):
    return json.loads((pathlib.Path(model).parent / "truth.json").read_text(encoding="utf-8"))


def _named(one):
    parameters = {name: {"value": value, "sigma": 1e-3} for name, value in one["parameters"].items()}
    parameters[one["size_parameter"]] = {"value": one["equivalent_value"], "sigma": 1e-3}
    return {"effect": one["effect"], "joint": one["joint"], "component": one["component"], "confidence": 0.95,
            "parameters": parameters, "lookalikes": []}


def _read(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def _discover(knows, model_path, out):
    truth = _truth(model_path)
    found = [_named(one) for one in truth["hidden"] if one["effect"] != "unknown"] if knows else []
    is_unknown = any(one["effect"] == "unknown" for one in truth["hidden"])
    verdict = "none" if not (truth["hidden"] and knows) else ("unknown" if is_unknown else "explained")
    for one in found if not truth["separable"] else []:
        one["confidence"], one["lookalikes"] = 0.6, truth["lookalike_group"][1:]
    model = _read(model_path)
    model["effects"] += [{**one, "source": "discovered"} for one in found]
    files.write_json(pathlib.Path(out), model)
    faults = [{"text": one["kind"], "file": one["file"], "rows": one["rows"]} for one in truth["faults"] if knows]
    return json.dumps({"verdict": verdict, "gap": {"significant": bool(found), "closed_pct": 99.0 if found else 0.0},
                       "effects": found, "data_quality": faults})


def _model_errors(case, model, whole):
    errors = machines.ErrorState(whole.n)
    for one in model["effects"]:
        if one["effect"] == "table":
            unit = "mm" if "start_mm" in one else "deg"
            periodic = case.machine.joints[one["joint"]].continuous
            table = tables.Table(one["component"], one[f"start_{unit}"], one[f"spacing_{unit}"],
                                 one.get("values_um", one.get("values_arcsec")), one["interpolation"], periodic)
            errors.add(one["component"], table.at(whole.q[one["joint"]]))
        elif one["effect"] == "location":
            errors.add_location(one["component"], one.get("value_um", one.get("value_arcsec")))
        else:
            plain = {**one, "parameters": {name: p["value"] for name, p in one["parameters"].items()}}
            for component, standing, values in effects.contribution(case.machine, plain, whole):
                errors.add(component, values, standing)
    return errors


def _predict(case, model_path, measured, out):
    model = _read(model_path)
    file = next(one for one in case.fresh if one.name == pathlib.Path(measured).stem)
    predicted = readings.read(case.machine, file, file.whole, _model_errors(case, model, file.whole))
    columns = {}
    for name, values in predicted.items():
        zero = np.mean(file.readings[name] - values) if file.instrument in readings.HAS_ZERO else 0.0
        columns[f"residual_{name}"] = file.readings[name] - values - zero
    lines = [",".join(columns)] + [",".join(f"{v:.6f}" for v in row) for row in zip(*columns.values())]
    pathlib.Path(out).write_text("\n".join(lines) + "\n", encoding="utf-8")
    return ""


class StandIn:
    """Takes the program's arguments, gives its stdout."""

    def __init__(self, knows):
        self.knows, self.case = knows, None

    def __call__(self, arguments):
        words = [str(one) for one in arguments]
        model, out = words[words.index("--model") + 1], words[words.index("--out") + 1]
        if "discover" in words:
            return _discover(self.knows, model, out)
        seed = _truth(model)["seed"]
        if self.case is None or self.case.seed != seed:
            self.case = cases.draw(seed)
        return _predict(self.case, model, words[words.index("--model") + 2], out)
