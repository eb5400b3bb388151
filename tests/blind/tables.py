"""Error tables: smooth true ones, interpolation (natural or periodic cubic, linear), and as an earlier calibration
measured them."""

import numpy as np


def _second_derivatives(values, step, periodic):
    """Those of the cubic spline through equally spaced values; natural ends, or periodic with period n steps."""
    n = len(values)
    system, right = np.zeros((n, n)), np.zeros(n)
    for i in range(n):
        if not periodic and i in (0, n - 1):
            system[i, i] = 1.0
            continue
        system[i, (i - 1) % n] += 1.0
        system[i, i] += 4.0
        system[i, (i + 1) % n] += 1.0
        right[i] = 6 * (values[(i - 1) % n] - 2 * values[i] + values[(i + 1) % n]) / step**2
    return np.linalg.solve(system, right)


class Table:
    """Values on an equal grid, the joint component they belong to, and how they are read between."""

    def __init__(self, component, start, step, values, interpolation="cubic", periodic=False):
        self.component, self.start, self.step = component, start, step
        self.values, self.interpolation, self.periodic = np.asarray(values, float), interpolation, periodic
        cubic = interpolation == "cubic" and len(self.values) > 2
        self._m = _second_derivatives(self.values, step, periodic) if cubic else np.zeros(len(self.values))

    @property
    def joint(self):
        return self.component[2:]

    def at(self, q):
        place, n = (np.asarray(q, float) - self.start) / self.step, len(self.values)
        place = np.mod(place, n) if self.periodic else np.clip(place, 0, n - 1)
        left = np.floor(place).astype(int)
        left = left % n if self.periodic else np.minimum(left, n - 2)
        b = place - left
        a, right = 1 - b, (left + 1) % n
        bend = ((a**3 - a) * self._m[left] + (b**3 - b) * self._m[right]) * self.step**2 / 6
        return a * self.values[left] + b * self.values[right] + bend

    def with_values(self, values):
        return Table(self.component, self.start, self.step, values, self.interpolation, self.periodic)

    def text(self, sigma=None):
        """The effect of a model file; sigma (same unit as the values) where the calibration stated one."""
        angle = self.component[1] in "ABC"
        kind, place = ("arcsec" if angle else "um"), ("deg" if self.is_rotary() else "mm")
        text = {"effect": "table", "joint": self.joint, "component": self.component,
                f"start_{place}": self.start, f"spacing_{place}": self.step,
                f"values_{kind}": [round(float(v), 4) for v in self.values],
                "interpolation": self.interpolation, "source": "measured"}
        if sigma is not None:
            text[f"sigma_{kind}"] = round(float(sigma), 4)
        return text

    def is_rotary(self):
        return self.joint[0] in "ABC"


def _smooth(rng, u, size):
    """A smooth curve over u in [-1, 1]: low polynomials and two slow waves, of about that size."""
    curve = rng.normal() * u + 0.7 * rng.normal() * (u**2 - 1 / 3) + 0.5 * rng.normal() * (u**3 - 0.6 * u)
    for _ in range(2):
        curve = curve + 0.35 * rng.normal() * np.sin(rng.uniform(2.0, 6.0) * u + rng.uniform(0, 6.28))
    return size * curve


def _periodic(rng, angle, size):
    curve = np.zeros_like(angle)
    for harmonic in (1, 2, 3):
        curve = curve + rng.normal() / harmonic * np.sin(harmonic * angle + rng.uniform(0, 6.28))
    return 0.6 * size * curve


def _grid(joint, rng):
    if joint.continuous:
        step = float(rng.choice([10, 15]))
        return 0.0, step, np.arange(0, 360, step)
    low, high = joint.travel
    step = float(rng.choice([25, 40, 50])) if joint.linear else 15.0
    return float(low), step, np.arange(low, high + 1e-9, step)


def draw_true(joint, rng, size_um, size_arcsec):
    """The six true error tables of a joint."""
    start, step, nodes = _grid(joint, rng)
    interpolation = "linear" if rng.random() < 0.15 else "cubic"
    tables = []
    for letter in "XYZABC":
        size = (size_arcsec if letter in "ABC" else size_um) * rng.uniform(0.5, 1.2)
        if joint.continuous:
            values = _periodic(rng, np.radians(nodes), size)
        else:
            values = _smooth(rng, 2 * (nodes - nodes[0]) / (nodes[-1] - nodes[0]) - 1, size)
        tables.append(Table(f"E{letter}{joint.letter}", start, step, values, interpolation, joint.continuous))
    return tables


def as_measured(table, rng, sigma_um, sigma_arcsec):
    """The table that the last calibration wrote: true values and its noise."""
    sigma = sigma_arcsec if table.component[1] in "ABC" else sigma_um
    return table.with_values(np.round(table.values + sigma * rng.normal(size=len(table.values)), 3)), sigma
