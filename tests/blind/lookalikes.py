"""Cases that no data of their campaign can decide, and structures outside the library."""

import hidden


class Look:
    """A hidden effect, the options that make it undecidable, and the (effect, joint) that look the same."""

    def __init__(self, effect, options, others):
        self.effect, self.options = effect, options
        self.group = [{"effect": effect["effect"], "joint": effect["joint"]}] + [
            {"effect": name, "joint": effect["joint"]} for name in others]


def _one_temperature(machine, rng):
    effect = hidden.DRAWERS["thermal_screw" if rng.random() < 0.5 else "scale"](machine, rng)
    other = "scale" if effect and effect["effect"] == "thermal_screw" else "thermal_screw"
    if effect and "q_fixed" in effect["parameters"]:
        effect["parameters"]["q_fixed"] = 0.0  # else the files without an unknown zero would tell
    return effect and Look(effect, {"one_temperature": True}, [other, "thermal_scale"])


def _one_height(machine, rng):
    if machine.id != "rotary-table":  # a lead or a volume file would tell
        return None
    name = str(rng.choice(["eccentricity", "wobble"]))
    return Look(hidden.DRAWERS[name](machine, rng), {"one_height": True}, list({"eccentricity", "wobble"} - {name}))


def _lonely_laser(machine, rng):
    if machine.id == "b2-k3032":
        return None
    effect = hidden.DRAWERS["scale"](machine, rng)
    return effect and Look(effect, {"linear_only": True, "one_temperature": True},
                           ["cosine", "material_temperature", "thermal_screw", "thermal_scale", "air_wavelength"])


def choose(case, rng):
    """A situation that this machine can be in."""
    found = None
    while found is None:
        makers = [_one_temperature, _one_height, _lonely_laser]
        if not case.machine.linear_joints():
            makers = [_one_height]
        found = makers[int(rng.integers(len(makers)))](case.machine, rng)
    return found


def unknown(machine, rng):
    """A structure without a name on a joint's own or lateral component."""
    kinds = ["step", "bump_one_way", "chirp", "load_times_temperature", "root_of_temperature", "kink", "bump"]
    kind = str(rng.choice(kinds))
    joints = machine.linear_joints()
    if not joints:
        return _on_rotary(machine, rng)
    joint = joints[int(rng.integers(len(joints)))]
    low, high = joint.travel
    at = float(low + rng.uniform(0.25, 0.75) * (high - low))
    half = float(rng.uniform(0.05, 0.15) * (high - low))
    return {"effect": "unknown", "kind": kind, "joint": joint.letter, "component": joint.positioning,
            "parameters": {"amplitude": 1.0, "at": round(at, 1), "from": round(at - half, 1), "to": round(at + half, 1),
                           "turns": round(float(rng.uniform(1.5, 3.0)), 3), "phase": float(rng.uniform(0, 6.28)),
                           "sensor": f"screw_{joint.letter}"}}


def _on_rotary(machine, rng):
    at = float(rng.uniform(60, 280))
    return {"effect": "unknown", "kind": str(rng.choice(["bump", "bump_one_way", "step"])), "joint": "C",
            "component": "ECC", "parameters": {"amplitude": 1.0, "at": at, "from": at - 25, "to": at + 25}}
