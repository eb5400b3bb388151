"""The effects of the contract's table, written from its formulas: what each adds to which error component.

`contribution(machine, effect, whole)` gives a list of (component, standing frame?, values in um or arcsec) over the
samples. What a joint does in its own sense (scale, backlash, …) acts along its `direction`.
An effect is a dict with `effect`, `joint`, `component` and `parameters` (numbers or names), as in a model file.
"""

import numpy as np

from states import lagged

DEGREE = np.pi / 180.0
# A rotor's eccentricity, lobing and wobble are written in the standing frame: there a cos(C + phi), a sin(C + phi) is
# a shift that turns with the body, once per turn on a dial. (In the moved frame a dial would see two waves.)
ROTOR_IN_STANDING_FRAME = True


def _u(machine, joint, q):
    low, high = machine.joints[joint].travel
    return 2 * (q - low) / (high - low) - 1


def _shape(name, u):
    return {"bow": u**2 - 1 / 3, "s": u**3 - 0.6 * u, "linear": u}[name]


class View:
    """One effect's look at the samples: its joint's q, s, v, a, d, and the parameters as attributes of `p`."""

    def __init__(self, machine, effect, whole):
        letter = effect["joint"]
        self.machine, self.whole, self.joint = machine, whole, letter
        self.q, self.s, self.v = whole.q[letter], whole.s[letter], whole.v[letter]
        self.a, self.d, self.p = whole.a[letter], whole.d[letter], effect["parameters"]
        self.linear = machine.joints[letter].linear

    def u(self):
        return _u(self.machine, self.joint, self.q)

    def temperature(self, name="sensor"):
        return self.whole.temps[self.p[name]]

    def wave(self, n=1.0):
        return np.sin(n * self.q * DEGREE + self.p["phase"] * DEGREE)

    def column(self):
        sensor = self.p["sensor"]
        return self.whole.temps[sensor] - 20.0 if sensor in self.whole.temps else self.whole.columns[sensor]

    def rate(self):
        """v for a lag in ms: um, or arcsec for a rotary joint."""
        return self.p["tau"] * self.v * (1.0 if self.linear else 3.6)


def _cyclic(e):
    return e.p["amplitude"] * np.sin(2 * np.pi * e.q / e.p["period"] + e.p["phase"] * DEGREE)


def _fade(e):
    return np.exp(-e.d / e.p["length"])


def _by_lag(e):
    """File by file the state starts in equilibrium, so the lag runs over the whole file."""
    return e.p["k"] * lagged(e.whole.t, e.column(), e.p["tau"])


FORMULAS = {
    "scale": lambda e: e.p["k"] * e.q / 1000,
    "cyclic": _cyclic,
    "straightness": lambda e: e.p["amplitude"] * _shape(e.p["shape"], e.u()),
    "angular": lambda e: e.p["amplitude"] * _shape(e.p["shape"], e.u()),
    "periodic_tilt": _cyclic,
    "axial_runout": lambda e: e.p["amplitude"] * e.wave(),
    "encoder_eccentricity": lambda e: e.p["amplitude"] * e.wave(),
    "backlash": lambda e: -e.p["width"] / 2 * e.s,
    "lateral_play": lambda e: -e.p["width"] / 2 * e.s,
    "angular_play": lambda e: -e.p["width"] / 2 * e.s,
    "windup": lambda e: -e.p["k"] * e.q / 1000 / 2 * e.s,
    "lost_motion": lambda e: -e.p["kappa"] * e.whole.load / 2 * e.s,
    "hysteresis": lambda e: -e.p["width"] / 2 * e.s * (1 - 2 * _fade(e)),
    "reversal_spike": lambda e: -e.p["height"] * e.s * _fade(e) * (np.abs(e.v) > 0),
    "servo_lag": lambda e: -e.rate(),
    "acceleration": lambda e: e.p["k"] * e.a / 1000,
    "vibration": lambda e: e.p["amplitude"] * np.sin(2 * np.pi * e.p["frequency"] * e.whole.t
                                                     + e.p["phase"] * DEGREE),
    "thermal_screw": lambda e: e.p["k"] * (e.temperature() - 20) * (e.q - e.p["q_fixed"]) / 1000,
    "thermal_head": _by_lag,
    "thermal_ambient": _by_lag,
    "coolant": _by_lag,
    "thermal_tilt": lambda e: e.p["k"] * (e.temperature() - e.temperature("sensor_2")),
    "drift": lambda e: e.p["rate"] * e.whole.t / 3600,
    "sag": lambda e: -e.p["k"] * ((e.q - e.p["q_ref"]) / 1000) ** 2,
    "load_deformation": lambda e: e.p["k"] * e.whole.load,
    "load_tilt": lambda e: e.p["k"] * e.whole.load,
    "wheel_wear": lambda e: e.p["rate"] * e.whole.wheel_pass,
    "wheel_deflection": lambda e: e.p["k"] * e.whole.feed / 1000,
}


def _round(e, components, n, amplitude):
    angle, standing = n * e.q * DEGREE + e.p["phase"] * DEGREE, ROTOR_IN_STANDING_FRAME
    return [(components[0], standing, amplitude * np.cos(angle)), (components[1], standing, amplitude * np.sin(angle))]


def contribution(machine, effect, whole):
    """What the effect adds."""
    e, name = View(machine, effect, whole), effect["effect"]
    letter = effect["joint"]
    if name in ("eccentricity", "lobing"):
        return _round(e, (f"EX{letter}", f"EY{letter}"), e.p.get("n", 1), e.p["amplitude"])
    if name == "wobble":
        return _round(e, (f"EA{letter}", f"EB{letter}"), 1, e.p["amplitude"])
    return [(effect["component"], False, own_sense(machine, effect) * FORMULAS[name](e))]


def own_sense(machine, effect):
    """-1 where the effect adds to the positioning of a joint whose direction is against the frame's axis."""
    joint = machine.joints[effect["joint"]]
    return -1.0 if joint.is_reversed and effect["component"] == joint.positioning else 1.0
