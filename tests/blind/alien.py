"""Formulas other than the library's: named effects as nature bends them, and structures that no library has.

`bent(effect)` gives a contribution function for a named effect; `unknown(...)` one for a structure without a name.
"""

import numpy as np

import effects
from effects import View

DEGREE = np.pi / 180.0


def _plain(machine, effect, whole):
    return effects.contribution(machine, effect, whole)


def _scaled(change):
    """A bent form that multiplies or adds to each component of the library's."""
    def formula(machine, effect, whole):
        e, b = View(machine, effect, whole), effect["bend"]
        return [(component, standing, change(e, np.asarray(values, float), b))
                for component, standing, values in _plain(machine, effect, whole)]
    return formula


def _screw_profile(e, _value, b):
    """Growth as the integral of a temperature along the screw that is highest where the nut works."""
    low, high = e.machine.joints[e.joint].travel
    middle, half = (low + high) / 2, (high - low) / 2
    rise = e.temperature() - 20

    def integral(q):
        x = (q - middle) / half
        return q + b * half * (x - x**3)          # of 1 + b (1 - 3 x^2): mean over the travel is 1
    sense = -1.0 if e.machine.joints[e.joint].is_reversed else 1.0
    return sense * e.p["k"] * rise * (integral(e.q) - integral(e.p["q_fixed"])) / 1000


def _soft_reversal(e, value, b):
    """Play that is taken up over a fraction of a millimetre."""
    return value * (1 - 1.6 * np.exp(-e.d / (0.3 * b)))


def _second_harmonic(e, value, b):
    shape = np.sin(4 * np.pi * e.q / e.p["period"] + 1.0) if "period" in e.p else np.sin(2 * e.q * DEGREE + 1.0)
    return value + b * e.p["amplitude"] * shape


def _cubed(e, value, b):
    return value * (1 + b * e.u())


def _worn(e, value, b):
    """Wear that slows down."""
    n = e.whole.wheel_pass
    return e.p["rate"] * (n - b * n**2 / 18.0)


def _two_lags(e, value, b):
    from states import lagged
    slow = lagged(e.whole.t, e.column(), e.p["tau"])
    return e.p["k"] * ((1 - b) * slow + b * lagged(e.whole.t, slow, 0.4 * e.p["tau"]))


def _by_speed(e, value, b):
    return value * (1 + b * np.tanh(np.abs(e.v) / 60.0 - 0.5))


def _stiffer(e, value, b):
    return value * (1 - b * e.whole.load / 450.0)


def _sharper(e, value, b):
    return value * np.exp(-b * np.minimum(e.d / e.p["length"], 30.0))


BENDS = {  # effect: (the bent form, how strong at most)
    "thermal_screw": (_screw_profile, 0.25), "backlash": (_soft_reversal, 0.8), "lateral_play": (_soft_reversal, 0.8),
    "angular_play": (_soft_reversal, 0.8), "cyclic": (_second_harmonic, 0.12),
    "periodic_tilt": (_second_harmonic, 0.12),
    "eccentricity": (_second_harmonic, 0.1), "wobble": (_second_harmonic, 0.1), "axial_runout": (_second_harmonic, 0.1),
    "encoder_eccentricity": (_second_harmonic, 0.1), "scale": (_cubed, 0.06), "windup": (_cubed, 0.06),
    "straightness": (_cubed, 0.1), "angular": (_cubed, 0.08), "wheel_wear": (_worn, 0.2),
    "servo_lag": (_by_speed, 0.08),
    "thermal_ambient": (_two_lags, 0.4), "thermal_head": (_two_lags, 0.4), "coolant": (_two_lags, 0.3),
    "load_deformation": (_stiffer, 0.12), "load_tilt": (_stiffer, 0.12), "lost_motion": (_stiffer, 0.12),
    "reversal_spike": (_sharper, 0.2)}


def can_bend(effect, machine, joint):
    """Whether nature's form of the effect is written for this joint."""
    needs_travel = effect in ("scale", "windup", "straightness", "angular", "thermal_screw")
    return effect in BENDS and not (needs_travel and machine.joints[joint].travel is None)


def draw_bend(effect, rng):
    return float(rng.uniform(0.4, 1.0) * BENDS[effect][1])


def contribution(machine, effect, whole):
    """What a hidden effect really adds: bent where it has a bend, with its own size from run to run where drawn."""
    if effect["effect"] == "unknown":
        shape = UNKNOWN[effect["kind"]](View(machine, effect, whole))
        parts = [(effect["component"], False, effect["parameters"]["amplitude"] * shape)]
    elif "bend" in effect:
        parts = _scaled(BENDS[effect["effect"]][0])(machine, effect, whole)
    else:
        parts = _plain(machine, effect, whole)
    return parts


# --- structures outside the library, of size 1

def _bump(e):
    low, high = e.p["from"], e.p["to"]
    inside = np.clip((e.q - low) / (high - low), 0, 1)
    return np.sin(np.pi * inside) ** 2


def _chirp(e):
    x = e.u()
    return np.sin(2 * np.pi * (e.p["turns"] * x + 0.35 * e.p["turns"] * x**2) + e.p["phase"])


UNKNOWN = {
    "step": lambda e: np.tanh((e.q - e.p["at"]) / 3.0),
    "bump": _bump,
    "bump_one_way": lambda e: _bump(e) * (e.s < 0),
    "chirp": _chirp,
    "load_times_temperature": lambda e: (e.whole.load - 150.0) / 300.0 * (e.temperature() - 24.0) / 6.0 * e.u(),
    "root_of_temperature": lambda e: np.sqrt(np.maximum(e.temperature() - 22.0, 0.0)) * np.sin(2.6 * e.u()),
    "kink": lambda e: np.maximum(e.q - e.p["at"], 0.0) / 200.0 * e.s,
}
