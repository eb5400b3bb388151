"""Draws hidden effects: which, on which joint, with which non-linear parameters; their size is set by the case."""

import alien

AXES = "XYZ"
SIZE_KEY = {"scale": "k", "windup": "k", "lost_motion": "kappa", "backlash": "width", "lateral_play": "width",
            "angular_play": "width", "hysteresis": "width", "reversal_spike": "height", "servo_lag": "tau",
            "acceleration": "k", "thermal_screw": "k", "thermal_head": "k", "thermal_ambient": "k", "coolant": "k",
            "thermal_tilt": "k", "drift": "rate", "sag": "k", "load_deformation": "k", "load_tilt": "k",
            "wheel_wear": "rate", "wheel_deflection": "k"}
UNITS = {"scale": "um/m", "windup": "um/m", "lost_motion": "um/kg", "servo_lag": "ms", "acceleration": "um/(m/s2)",
         "thermal_screw": "um/m/C", "thermal_head": "um/C", "thermal_ambient": "um/C", "coolant": "um",
         "thermal_tilt": "arcsec/C", "drift": "um/h", "load_deformation": "um/kg", "load_tilt": "arcsec/kg",
         "wheel_wear": "um/pass", "wheel_deflection": "um/(m/min)"}
MEMORY = {"hysteresis", "reversal_spike", "thermal_head", "thermal_ambient", "coolant"}
# Two names of one and the same function on such data; either counts.
SAME = {"thermal_screw": ["thermal_scale"], "servo_lag": ["sync_delay"], "thermal_head": ["thermal_ambient"],
        "thermal_ambient": ["thermal_head"], "encoder_eccentricity": ["cyclic"], "load_tilt": [], "lobing": []}
# A shift of the tool that no position changes: any joint of that side moves it alike.
PLACELESS = {"thermal_head", "thermal_ambient", "coolant", "drift", "load_deformation", "wheel_wear",
             "wheel_deflection", "vibration"}


def size_key(effect):
    return SIZE_KEY.get(effect["effect"], "amplitude")


def _lateral(joint, rng):
    others = [k for k in range(3) if k != joint.bed_axis]
    return AXES[int(rng.choice(others))]


def _tilt(joint, rng, roll=False):
    return "ABC"[joint.bed_axis] if roll else "ABC"["XYZ".index(_lateral(joint, rng))]


def _observed_laterals(machine, joint):
    """Bed axes along and about which the plan's straightness and angular files look at this joint."""
    wide = machine.id == "linear-stage" or (machine.id == "b2-k3032" and joint.letter == "Z")
    lateral = {"X": "YZ", "Y": "ZX", "Z": "XY"}[joint.letter]
    return lateral if wide else lateral[:1]


def _linear(machine, rng):
    every = machine.linear_joints()
    return every[int(rng.integers(len(every)))] if every else None


def _rotary(machine, _rng):
    return machine.joints.get("C")


def _own(name, extra=None):
    def draw(machine, rng):
        joint = _linear(machine, rng)
        return joint and _effect(name, joint, joint.positioning, extra(machine, joint, rng) if extra else {})
    return draw


def _lateral_of(name, letters, extra=None):
    """On a lateral component that the plan looks at: letters "XYZ" straightness, "ABC" tilt."""
    def draw(machine, rng):
        joint = _linear(machine, rng)
        if joint is None:
            return None
        axis = rng.choice(list(_observed_laterals(machine, joint)))
        component = f"E{letters['XYZ'.index(axis)]}{joint.letter}"
        return _effect(name, joint, component, extra(machine, joint, rng) if extra else {})
    return draw


def _rotor(name, component, extra):
    def draw(machine, rng):
        joint = _rotary(machine, rng)
        if joint is None or (joint.is_reversed and name != "axial_runout"):
            return None  # the contract does not say which way round a reversed rotor's eccentricity turns
        return _effect(name, joint, component, extra(machine, joint, rng))
    return draw


def _effect(name, joint, component, parameters):
    one = {"effect": name, "joint": joint.letter, "component": component, "parameters": parameters}
    return {**one, "frame": "fixed"} if name in ("eccentricity", "lobing", "wobble") else one


def _phase(rng):
    return round(float(rng.uniform(-180, 180)), 2)


def _screw(machine, joint, rng):
    return {"period": float(rng.choice([5, 8, 10, 12, 16])), "phase": _phase(rng)}


def _growth(machine, joint, rng):
    low, high = joint.travel
    return {"q_fixed": round(float(low + rng.choice([0.0, 0.1, 0.9, 1.0]) * (high - low)), 1),
            "sensor": f"screw_{joint.letter}"}


def _standing(name, sensor, taus):
    """A shift that follows a slow column, seen by the long watch: along one bed axis, placed at some joint."""
    def draw(machine, rng):
        side = machine.tool or machine.work
        joint = side[int(rng.integers(len(side)))]
        axis = AXES[int(rng.integers(3))]
        extra = {"sensor": sensor, "tau": round(float(rng.uniform(*taus)))} if sensor else {}
        return _effect(name, joint, f"E{axis}{joint.letter}", extra)
    return draw


def _with_load(name, letters):
    def draw(machine, rng):
        if name == "load_deformation":
            joint = _linear(machine, rng) or _rotary(machine, rng)
            component = f"EZ{joint.letter}"
            return None if machine.id == "b2-k3032" else _effect(name, joint, component, {})
        joint = _linear(machine, rng)
        return joint and _lateral_of(name, letters)(machine, rng)
    return draw


def _wheel(name):
    def draw(machine, _rng):
        return _effect(name, machine.joints["X"], "EXX", {}) if machine.id == "b2-k3032" else None
    return draw


def _tilting(machine, rng):
    drawn = _lateral_of("thermal_tilt", "ABC")(machine, rng)
    if drawn:
        drawn["parameters"] = {"sensor": "front", "sensor_2": "back"}
    return drawn


def _c_play(machine, rng):
    if machine.id not in ("b2-k3032", "rotary-table"):
        return None
    return _effect("backlash", machine.joints["C"], "ECC", {})


def _c_cyclic(machine, rng):
    if machine.id not in ("b2-k3032", "rotary-table"):
        return None
    return _effect("cyclic", machine.joints["C"], "ECC",
                   {"period": float(rng.choice([3.0, 4.0, 5.0])), "phase": _phase(rng)})


def _encoder(machine, rng):
    if machine.id not in ("b2-k3032", "rotary-table"):
        return None
    return _effect("encoder_eccentricity", machine.joints["C"], "ECC", {"n": 1, "phase": _phase(rng)})


def _shape(machine, joint, rng):
    return {"shape": str(rng.choice(["bow", "s"]))}


def _round(n):
    return lambda machine, joint, rng: {"n": int(rng.choice(n)), "phase": _phase(rng)}


DRAWERS = {
    "scale": _own("scale"), "cyclic": _own("cyclic", _screw), "backlash": _own("backlash"), "windup": _own("windup"),
    "lost_motion": _own("lost_motion"), "servo_lag": _own("servo_lag"), "acceleration": _own("acceleration"),
    "hysteresis": _own("hysteresis", lambda m, j, r: {"length": round(float(r.uniform(15, 90)), 1)}),
    "reversal_spike": _own("reversal_spike", lambda m, j, r: {"length": round(float(r.uniform(2, 12)), 2)}),
    "thermal_screw": _own("thermal_screw", _growth),
    "straightness": _lateral_of("straightness", "XYZ", _shape),
    "lateral_play": _lateral_of("lateral_play", "XYZ"), "angular_play": _lateral_of("angular_play", "ABC"),
    "angular": _lateral_of("angular", "ABC", lambda m, j, r: {"shape": "linear"}),
    "periodic_tilt": _lateral_of("periodic_tilt", "ABC", _screw),
    "thermal_tilt": _tilting, "load_tilt": _with_load("load_tilt", "ABC"),
    "load_deformation": _with_load("load_deformation", "XYZ"),
    "thermal_head": _standing("thermal_head", "head", (300, 2500)),
    "thermal_ambient": _standing("thermal_ambient", "ambient", (600, 4000)),
    "coolant": _standing("coolant", "coolant_1", (200, 1500)), "drift": _standing("drift", None, None),
    "wheel_wear": _wheel("wheel_wear"), "wheel_deflection": _wheel("wheel_deflection"),
    "eccentricity": _rotor("eccentricity", "EXC", _round([1])), "lobing": _rotor("lobing", "EXC", _round([2, 3])),
    "wobble": _rotor("wobble", "EAC", lambda m, j, r: {"phase": _phase(r)}),
    "axial_runout": _rotor("axial_runout", "EZC", lambda m, j, r: {"phase": _phase(r)}),
    "backlash_c": _c_play, "cyclic_c": _c_cyclic, "encoder_eccentricity": _encoder}


def draw(machine, rng, bent_share=0.67, among=None):
    """One effect that this machine can have, of size 1, two thirds of them bent away from the library's formula."""
    names = sorted(among or DRAWERS)
    while True:
        effect = DRAWERS[names[int(rng.integers(len(names)))]](machine, rng)
        if effect is None:
            continue
        effect["parameters"][size_key(effect)] = 1.0
        if alien.can_bend(effect["effect"], machine, effect["joint"]) and rng.random() < bent_share:
            effect["bend"] = alien.draw_bend(effect["effect"], rng)
        return effect


def unit_of(effect):
    if effect["effect"] in UNITS:
        return UNITS[effect["effect"]]
    return "arcsec" if effect["component"][1] in "ABC" else "um"


def equivalents(machine, effect):
    """Every (effect, joint) that names the same cause on such data."""
    names = [effect["effect"]] + SAME.get(effect["effect"], [])
    joints = [effect["joint"]]
    if effect["effect"] in PLACELESS:
        joints = list(machine.joints)
    found = [{"effect": name, "joint": joint} for name in names for joint in joints]
    if effect["effect"] == "cyclic" and not machine.joints[effect["joint"]].linear:
        found.append({"effect": "encoder_subdivision", "joint": effect["joint"]})
    if effect["effect"] == "straightness":
        found.append({"effect": "sag", "joint": effect["joint"]})
    return found
