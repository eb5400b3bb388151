"""One case from one seed: machine, baseline model, campaign, noise, what is hidden, a fresh campaign without noise."""

import copy

import numpy as np

import alien
import artefacts
import faults
import files
import hidden
import lookalikes
import machines
import noise
import plans
import readings
import tables
from campaign import Options
from effects import contribution as library_contribution

CATEGORIES = {"single": 0.30, "small": 0.07, "pair": 0.15, "triple": 0.08, "null": 0.13, "unknown": 0.11,
              "lookalike": 0.06, "fault": 0.05, "artefact": 0.05}
COUNT = {"single": 1, "small": 1, "pair": 2, "triple": 3}
MACHINE_ODDS = {"b2-k3032": 0.35, "generic-3axis": 0.25, "trunnion-ac": 0.15, "rotary-table": 0.1, "linear-stage": 0.15}


class Case:
    def __init__(self, seed):
        self.seed = seed
        self.rng = np.random.default_rng([seed, 20])
        self.category = str(self.rng.choice(list(CATEGORIES), p=list(CATEGORIES.values())))
        self.hidden, self.look, self.artefact = [], None, None


def category_of(seed):
    return Case(seed).category


def _baseline(case):
    """True tables and locations, and what the model file says of them."""
    rng, machine = case.rng, case.machine
    size = rng.uniform(2.0, 4.0)
    case.tables = [one for joint in machine.joints.values() for one in tables.draw_true(joint, rng, size, 0.7 * size)]
    level = rng.uniform(0.05, 0.3)
    case.table_noise = (level * case.sigma["um"], level * case.sigma["arcsec"])
    measured = [tables.as_measured(one, rng, *case.table_noise) for one in case.tables]
    says = rng.random() < 0.6
    case.location, model_location = {}, {}
    for name in _location_names(machine):
        case.location[name] = float(rng.normal() * (2.5 if name[0] in "ABC" else 5.0))
        model_location[name] = case.location[name] + float(rng.normal() * level * (0.3 if name[0] in "ABC" else 0.4))
    case.model = files.model_text(machine, [one for one, _ in measured],
                                  [sigma if says else None for _, sigma in measured], model_location)


def _location_names(machine):
    return {"b2-k3032": ["B0X", "A0C", "B0C", "X0C", "Y0C"], "generic-3axis": ["C0X", "B0Z", "A0Z"],
            "trunnion-ac": ["B0A", "C0A", "A0C", "B0C", "X0C", "Y0C"], "rotary-table": ["A0C", "B0C"],
            "linear-stage": []}[machine.id]


def baseline_errors(case, whole):
    errors = machines.ErrorState(whole.n)
    for table in case.tables:
        errors.add(table.component, table.at(whole.q[table.joint]))
    for component, value in case.location.items():
        errors.add_location(component, value)
    return errors


def true_readings(case, file, effects, wobble=None):
    """Readings without noise; `wobble` gives each effect's own size run by run."""
    errors = baseline_errors(case, file.whole)
    for k, effect in enumerate(effects):
        size = 1.0 if wobble is None else wobble[k][file.whole.run_index]
        for component, standing, values in alien.contribution(case.machine, effect, file.whole):
            errors.add(component, size * values, standing)
    return readings.read(case.machine, file, file.whole, errors)


def signature(case, effect, formula, tiny=1.0):
    """What an effect of that formula does to every reading in units of its sigma, unknown zeros taken out."""
    found = []
    for file in case.files:
        if file.undisturbed is None:
            file.undisturbed = true_readings(case, file, [])
        before = file.undisturbed
        errors = baseline_errors(case, file.whole)
        for component, standing, values in formula(case.machine, effect, file.whole):
            errors.add(component, tiny * values, standing)
        after = readings.read(case.machine, file, file.whole, errors)
        for column in sorted(before):
            change = (after[column] - before[column]) / tiny / file.sigma_of(column)
            found.append(change - change.mean() if file.instrument in readings.HAS_ZERO else change)
    return found


def _set_size(case, effect, sigmas):
    """Scales the effect so that its largest reading is `sigmas` times the repeatability; notes what that means."""
    key, unit = hidden.size_key(effect), signature(case, effect, alien.contribution)
    largest = max(float(np.max(np.abs(one))) for one in unit)
    if largest <= 1e-9:
        return False
    sense = 1.0 if effect["effect"] == "sag" else float(case.rng.choice([-1, 1]))
    effect["parameters"][key] = sense * sigmas / largest
    scaled = sigmas / largest
    effect["amplitude_sigma"] = sigmas
    effect["non_centrality"] = float(sum(np.sum((scaled * one) ** 2) for one in unit))
    return effect["non_centrality"] >= (150.0 if case.category != "small" else 60.0)


def _equivalent_size(case, effect):
    """The library parameter that comes nearest to what nature really does (the bent formula), by least squares."""
    key = hidden.size_key(effect)
    value = effect["parameters"][key]
    if "bend" not in effect:
        return value
    real = np.concatenate(signature(case, effect, alien.contribution))
    library = np.concatenate(signature(case, effect, library_contribution))
    return float(value * (real @ library) / (library @ library))


def _hide(case):
    """Draws the category's hidden effects with their sizes."""
    rng = case.rng
    while len(case.hidden) < COUNT.get(case.category, 0):
        first_remembers = case.options.split_runs and not case.hidden and rng.random() < 0.6
        effect = hidden.draw(case.machine, rng, among=hidden.MEMORY if first_remembers else None)
        taken = {(one["joint"], one["component"]) for one in case.hidden}
        if (effect["joint"], effect["component"]) in taken and rng.random() < 0.7:
            continue
        if any(_clashes(effect, one) for one in case.hidden):
            continue
        if effect["effect"] in hidden.MEMORY and not case.options.split_runs:
            continue
        sigmas = rng.uniform(1.2, 3.5) if case.category == "small" else rng.uniform(4.5, 14.0)
        if _set_size(case, effect, sigmas):
            case.hidden.append(effect)


def _clashes(a, b):
    """Two hidden effects that nobody could keep apart by name."""
    same_place = (a["joint"], a["component"]) == (b["joint"], b["component"])
    group = lambda one: one["effect"] in hidden.PLACELESS
    return (same_place and a["effect"] == b["effect"]) or (group(a) and group(b)) or (
        same_place and {a["effect"], b["effect"]} <= {"backlash", "hysteresis", "windup", "lost_motion"})


def _draw_machine(case, rng):
    while True:
        machine = machines.draw(str(rng.choice(list(MACHINE_ODDS), p=list(MACHINE_ODDS.values()))), rng)
        if case.category != "artefact" or machine.linear_joints():
            return machine


def draw(seed):
    """The whole case, in memory: `files` with readings, `fresh` with noise-free readings."""
    case = Case(seed)
    rng = case.rng
    case.machine = _draw_machine(case, rng)
    if case.category == "lookalike":
        case.look = lookalikes.choose(case, rng)
    size = rng.uniform(0.25, 0.6)
    case.sigma = {"um": round(size, 3), "arcsec": round(size * rng.uniform(0.6, 1.0), 3)}
    splits = bool(rng.random() < 0.15) and case.category in (*COUNT, "null")
    options = {"split_runs": splits} if case.look is None else case.look.options
    case.options = Options(**options)
    case.files = plans.build(case.machine, rng, case.options, case.sigma)
    _baseline(case)
    if case.category == "unknown":
        _hide_unknown(case)
    elif case.look is not None:
        _hide_look(case)
    else:
        _hide(case)
    case.fresh = plans.build(case.machine, rng, Options(**{**options, "fresh": True}), case.sigma)
    _observe(case)
    return case


def _hide_unknown(case):
    while not case.hidden:
        effect = lookalikes.unknown(case.machine, case.rng)
        if _set_size(case, effect, case.rng.uniform(5, 14)):
            case.hidden.append(effect)


def _hide_look(case):
    effect = case.look.effect
    effect["parameters"][hidden.size_key(effect)] = 1.0
    _set_size(case, effect, case.rng.uniform(5, 14))
    case.hidden.append(effect)


def _observe(case):
    """Readings as the instruments show them, and the fresh campaign's true ones."""
    rng = case.rng
    case.noise = noise.Noise(rng)
    vary = 0.04 if rng.random() < 0.5 else 0.0
    case.artefact, spoilt, added = artefacts.hide(case) if case.category == "artefact" else (None, None, 0.0)
    for file in case.files:
        runs = int(file.whole.run_index.max()) + 1
        wobble = [1.0 + vary * rng.normal(size=runs) for _ in case.hidden]
        truth = true_readings(case, file, case.hidden, wobble)
        if file.name == spoilt:
            truth["dev_um"] = truth["dev_um"] + added
        file.readings = {name: case.noise.observe(file, name, values) for name, values in truth.items()}
    for file in case.fresh:
        file.readings = true_readings(case, file, case.hidden)
    case.faults, case.sensor_faults = faults.spoil(case, rng) if case.category == "fault" else ([], {})


def truth_record(case):
    effects = []
    for effect in case.hidden:
        one = copy.deepcopy(effect)
        key = hidden.size_key(effect)
        if effect["effect"] != "unknown":
            one["size_parameter"], one["equivalent_value"] = key, _equivalent_size(case, effect)
            one["unit"] = hidden.unit_of(effect)
            one["sign_free"] = bool(case.machine.joints[effect["joint"]].is_reversed)
            one["equivalents"] = hidden.equivalents(case.machine, effect)
        effects.append(one)
    return {"seed": case.seed, "category": case.category, "machine": case.machine.id, "hidden": effects,
            "separable": case.look is None, "lookalike_group": case.look.group if case.look else [],
            "faults": case.faults, "artefact": case.artefact, "sigma": case.sigma, "noise": case.noise.text(),
            "table_noise": case.table_noise,
            "samples": int(sum(file.whole.n for file in case.files)), "location": case.location,
            "tables": [{"component": t.component, "start": t.start, "spacing": t.step, "values": t.values,
                        "interpolation": t.interpolation} for t in case.tables]}


def write(case, folder):
    """model.json, first/*.csv, fresh/*.csv and truth.json."""
    speeds = bool(case.rng.random() < 0.5)
    for name, campaign_files in (("first", case.files), ("fresh", case.fresh)):
        (folder / name).mkdir(parents=True, exist_ok=True)
        for file in campaign_files:
            file.machine_id = case.machine.id
            declared = {unit: case.noise.declared_sigma(file, unit) for unit in ("um", "arcsec")}
            files.write_measurement(folder / name / f"{file.name}.csv", case.machine, file, declared,
                                    case.sensor_faults if name == "first" else {}, speeds,
                                    0.05 if name == "first" else 0.0005)
    files.write_json(folder / "model.json", case.model)
    files.write_json(folder / "truth.json", truth_record(case))
