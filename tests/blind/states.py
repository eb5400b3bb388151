"""What the machine does during a run: commanded joints with their history, and the conditions (temperatures, load, …).

A `Run` holds arrays of n samples: t (s), and per joint letter q (mm, deg), s (approach, -1 or +1), v (mm/s, deg/s),
a (per s^2), d (travel since the last reversal; infinite before the first, the machine starts in equilibrium).
"""

import numpy as np


class Run:
    def __init__(self, machine, t):
        n = len(t)
        self.t, self.n = np.asarray(t, float), n
        letters = machine.joints
        self.q = {letter: np.zeros(n) for letter in letters}
        self.s = {letter: np.ones(n) for letter in letters}
        self.v = {letter: np.zeros(n) for letter in letters}
        self.a = {letter: np.zeros(n) for letter in letters}
        self.d = {letter: np.full(n, np.inf) for letter in letters}
        self.temps, self.columns = {}, {}
        self.load = np.zeros(n)
        self.wheel_pass = np.zeros(n)
        self.feed = np.zeros(n)
        self.moving = []          # letters of the joints that move in this run
        self.is_stepped = True    # stopped, then read

    def hold(self, **positions):
        for letter, value in positions.items():
            if letter in self.q:
                self.q[letter] = np.full(self.n, float(value))
        return self


def history(q, first_sense=None):
    """Approach and travel since the last reversal along positions in the order in which they were taken."""
    step = np.diff(q)
    moved = step[np.abs(step) > 1e-9]
    sense = first_sense if first_sense is not None else (np.sign(moved[0]) if len(moved) else 1.0)
    s, d = np.empty(len(q)), np.empty(len(q))
    travel = np.inf
    for i in range(len(q)):
        delta = 0.0 if i == 0 else step[i - 1]
        if abs(delta) > 1e-9:
            if np.sign(delta) != sense:
                sense, travel = np.sign(delta), 0.0
            travel += abs(delta)
        s[i], d[i] = sense, travel
    return s, d


def stepped(machine, letter, targets, t0, seconds=6.0):
    """To each target, stop, read; the turning point is read once, coming from the side of the first stroke."""
    run = Run(machine, t0 + seconds * np.arange(len(targets)))
    run.q[letter] = np.asarray(targets, float)
    run.s[letter], run.d[letter] = history(run.q[letter])
    run.moving = [letter]
    return run


def pendulum(targets, cycles=1):
    """Up and back again `cycles` times; turning points once each."""
    up, one = np.asarray(targets, float), [np.asarray(targets, float)]
    for cycle in range(cycles):
        one.append(up[-2::-1])
        if cycle + 1 < cycles:
            one.append(up[1:])
    return np.concatenate(one)


def oscillating(machine, letter, centre, amplitude, feed, t0, samples, periods=2.0):
    """Back and forth as a sine: the largest speed is `feed` (mm/min or deg/min); read while moving."""
    omega = feed / 60.0 / amplitude
    local = np.linspace(0, periods * 2 * np.pi / omega, samples)
    phase = omega * local - 0.4
    run = Run(machine, t0 + local)
    run.q[letter] = centre + amplitude * np.sin(phase)
    run.v[letter] = amplitude * omega * np.cos(phase)
    run.a[letter] = -amplitude * omega**2 * np.sin(phase)
    _finish_moving(run, [letter], feed)
    return run


def circle(machine, letters, centre, radius, feed, t0, samples, clockwise, signs):
    """Two joints round a circle of their plane, starting at 45 degrees, a little more than one turn."""
    omega = (-1 if clockwise else 1) * feed / 60.0 / radius
    local = np.linspace(0, 2.1 * np.pi / abs(omega), samples)
    angle = np.pi / 4 + omega * local
    run = Run(machine, t0 + local)
    waves = ((np.cos(angle), -np.sin(angle)), (np.sin(angle), np.cos(angle)))
    for letter, middle, sign, (wave, slope) in zip(letters, centre, signs, waves):
        run.q[letter] = middle + sign * radius * wave
        run.v[letter] = sign * radius * omega * slope
        run.a[letter] = -sign * radius * omega**2 * wave
    _finish_moving(run, letters, feed)
    run.columns["theta_deg"] = np.degrees(np.mod(angle, 2 * np.pi))
    return run


def uniform(machine, rates, start, feed, t0, seconds, samples):
    """Joints at constant speeds (mm/s, deg/s), such as a thread."""
    local = np.linspace(0, seconds, samples)
    run = Run(machine, t0 + local)
    for letter, rate in rates.items():
        run.q[letter] = start[letter] + rate * local
        run.v[letter] = np.full(samples, float(rate))
    _finish_moving(run, list(rates), feed)
    return run


def _finish_moving(run, letters, feed):
    run.moving, run.is_stepped = list(letters), False
    run.feed = np.full(run.n, float(feed))
    for letter in letters:
        first = np.sign(run.v[letter][0]) or 1.0
        run.s[letter], run.d[letter] = history(run.q[letter], first)


class Climate:
    """Temperatures of a campaign. Every sensor has its own story, some of them much alike: the bed follows the room
    slowly, the back of the column the front, the screws warm with use in an order that no clock gives away."""

    def __init__(self, machine, rng, warm_range=12.0, hold=False):
        self.rng, self.hold = rng, hold
        self.screws = [one.letter for one in machine.linear_joints()]
        self.scale = {letter: rng.uniform(0.7, 1.2) * warm_range for letter in self.screws}
        self.room = 20.0 + rng.uniform(-0.8, 0.8)
        self.wave = (rng.uniform(0.4, 1.2), rng.uniform(14000, 30000), rng.uniform(0, 6.28))

    def _room(self, t):
        size, period, phase = self.wave
        return self.room + size * np.sin(2 * np.pi * t / period + phase)

    def apply(self, run, warmth):
        """Sets the true temperatures of a run whose machine is warm by `warmth` in 0…1."""
        rng, t = self.rng, run.t
        local = (t - t[0]) / max(t[-1] - t[0], 1.0)
        warmth = 0.5 if self.hold else warmth
        rise = 0.0 if self.hold else rng.uniform(0.0, 1.2)
        ambient = np.full(run.n, self.room) if self.hold else self._room(t)
        run.temps["ambient"] = ambient
        run.temps["bed"] = 0.5 * ambient + 10.3 + 0.8 * warmth + 0.1 * rise * local
        for letter in self.screws:
            share = np.clip(warmth + (0.0 if self.hold else rng.normal() * 0.12), 0, 1.2)
            run.temps[f"screw_{letter}"] = ambient + self.scale[letter] * share + rise * local
        front = ambient + (1.0 if self.hold else rng.uniform(0, 5))
        run.temps["front"], run.temps["back"] = front, ambient + (0.4 if self.hold else rng.uniform(0, 5))
        run.columns["coolant_1"] = np.zeros(run.n)
        run.columns["humidity_1"] = 0.45 - 0.02 * (ambient - 20.0) + 0.01 * rng.normal(size=run.n)
        run.temps["head"] = ambient + (4.0 if self.hold else rng.uniform(0, 9)) + 0.8 * rise * local


def lagged(t, value, tau):
    """First-order lag, exact for a value that runs straight between samples; in equilibrium at the first."""
    out = np.empty(len(t))
    out[0] = value[0]
    for i in range(1, len(t)):
        step = t[i] - t[i - 1]
        if step <= 0:
            out[i] = out[i - 1]
            continue
        slope, fade = (value[i] - value[i - 1]) / step, np.exp(-step / tau)
        target0 = value[i - 1] - slope * tau
        out[i] = value[i] - slope * tau + (out[i - 1] - target0) * fade
    return out


def joined(runs):
    """The runs of a file as one, in their order (history stays within each run)."""
    first = runs[0]
    whole = Run.__new__(Run)
    whole.t, whole.n = np.concatenate([r.t for r in runs]), sum(r.n for r in runs)
    for name in ("q", "s", "v", "a", "d", "temps", "columns"):
        setattr(whole, name, {key: np.concatenate([getattr(r, name)[key] for r in runs])
                              for key in getattr(first, name)})
    for name in ("load", "wheel_pass", "feed"):
        setattr(whole, name, np.concatenate([getattr(r, name) for r in runs]))
    whole.run_index = np.concatenate([np.full(r.n, i + 1) for i, r in enumerate(runs)])
    whole.moving, whole.is_stepped = first.moving, first.is_stepped
    return whole
