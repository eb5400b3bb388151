"""Machines of the blind trial: geometry after the contract's machine file, and exact forward kinematics.

Nothing here is shared with the program under test; the formulas are those of contract.md (conventions 1 to 3).
Lengths in mm, angles in rad, arrays of samples first.
"""

import math

import numpy as np

ARCSEC = math.pi / 648000.0
UM = 1e-3
FRAME_AXES = "XYZ"
COMPONENT_SLOT = {"X": 0, "Y": 1, "Z": 2, "A": 3, "B": 4, "C": 5}


class Joint:
    """One joint: `positioning` is the component of its own motion, such as EXX or ECC."""

    def __init__(self, text, on_work_side):
        self.letter, self.linear = text["axis"], text["type"] == "linear"
        self.direction = np.array(text["direction"], float)
        self.offset = np.array(text["offset_mm"], float)
        self.continuous = bool(text.get("continuous", False))
        self.travel = None if self.continuous else tuple(text["travel"])
        self.on_work_side = on_work_side
        self.bed_axis = int(np.argmax(np.abs(self.direction)))
        name = FRAME_AXES[self.bed_axis] if self.linear else "ABC"[self.bed_axis]
        self.positioning = f"E{name}{self.letter}"
        self.is_reversed = self.direction[self.bed_axis] < 0

    @property
    def unit(self):
        return "mm" if self.linear else "deg"


class Machine:
    def __init__(self, text):
        self.text, self.id = text, text["id"]
        self.work = [Joint(one, True) for one in text["workpiece_chain"]]
        self.tool = [Joint(one, False) for one in text["tool_chain"]]
        self.tip = np.array(text["tool"]["tip_mm"], float)
        self.joints = {one.letter: one for one in self.work + self.tool}

    def linear_joints(self):
        return [one for one in self.joints.values() if one.linear]

    def rotary_joints(self):
        return [one for one in self.joints.values() if not one.linear]


# --- rigid motions of n samples: rotations (n, 3, 3) and shifts (n, 3)

def rotations(vectors):
    """Rodrigues' formula for n rotation vectors."""
    vectors = np.asarray(vectors, float)
    angle = np.linalg.norm(vectors, axis=1)
    small = angle < 1e-6
    safe = np.where(small, 1.0, angle)
    first = np.where(small, 1.0 - angle**2 / 6, np.sin(safe) / safe)
    second = np.where(small, 0.5 - angle**2 / 24, 2 * np.sin(safe / 2) ** 2 / safe**2)
    cross = np.zeros((len(vectors), 3, 3))
    x, y, z = vectors.T
    cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -z, y, -x
    cross[:, 1, 0], cross[:, 2, 0], cross[:, 2, 1] = z, -y, x
    return np.eye(3) + first[:, None, None] * cross + second[:, None, None] * (cross @ cross)


def rotation_vectors(matrices):
    """The vectors of n rotations by less than half a turn."""
    v = 0.5 * np.stack([matrices[:, 2, 1] - matrices[:, 1, 2], matrices[:, 0, 2] - matrices[:, 2, 0],
                        matrices[:, 1, 0] - matrices[:, 0, 1]], axis=1)
    sine = np.linalg.norm(v, axis=1)
    cosine = (np.trace(matrices, axis1=1, axis2=2) - 1) / 2
    scale = np.where(sine < 1e-9, 1.0, np.arctan2(sine, cosine) / np.where(sine < 1e-9, 1.0, sine))
    return v * scale[:, None]


def compose(a, b):
    return a[0] @ b[0], a[1] + np.einsum("nij,nj->ni", a[0], b[1])


def apply(motion, points):
    points = np.broadcast_to(points, motion[1].shape)
    return motion[1] + np.einsum("nij,nj->ni", motion[0], points)


def inverse(motion):
    turned = np.swapaxes(motion[0], 1, 2)
    return turned, -np.einsum("nij,nj->ni", turned, motion[1])


def _shift(n, vector):
    return np.broadcast_to(np.eye(3), (n, 3, 3)), np.broadcast_to(np.asarray(vector, float), (n, 3))


class ErrorState:
    """Errors of n samples: per joint six columns (EX EY EZ in mm, EA EB EC in rad) in the moved frame and, for a
    rotary joint, in the standing frame; location errors are constants of a joint (same six)."""

    def __init__(self, n):
        self.n, self.moved, self.standing, self.location = n, {}, {}, {}

    def add(self, component, values, standing=False):
        """Adds values in um or arcsec to a component such as EXZ or EBC."""
        slot, joint = COMPONENT_SLOT[component[1]], component[2:]
        place = (self.standing if standing else self.moved).setdefault(joint, np.zeros((self.n, 6)))
        place[:, slot] += np.asarray(values, float) * (UM if slot < 3 else ARCSEC)

    def add_location(self, component, value):
        """A location error such as B0Z (arcsec) or X0C (um)."""
        slot, joint = COMPONENT_SLOT[component[0]], component[2:]
        self.location.setdefault(joint, np.zeros(6))[slot] += value * (UM if slot < 3 else ARCSEC)


def _joint_motion(joint, q, errors):
    n = errors.n
    location = errors.location.get(joint.letter, np.zeros(6))
    motion = compose(_shift(n, joint.offset), _six(n, np.tile(location, (n, 1))))
    if joint.letter in errors.standing:
        motion = compose(motion, _six(n, errors.standing[joint.letter]))
    if joint.linear:
        travel = np.outer(q, joint.direction)
        motion = compose(motion, (np.broadcast_to(np.eye(3), (n, 3, 3)), travel))
    else:
        motion = compose(motion, (rotations(np.outer(np.radians(q), joint.direction)), np.zeros((n, 3))))
    if joint.letter in errors.moved:
        motion = compose(motion, _six(n, errors.moved[joint.letter]))
    return motion


def _six(n, values):
    return rotations(values[:, 3:]), values[:, :3]


def bodies(machine, q, errors):
    """Poses in the bed of the body that each joint moves, besides "W" and "T" (the last bodies of the chains)."""
    found = {}
    for name, chain in (("W", machine.work), ("T", machine.tool)):
        pose = _shift(errors.n, np.zeros(3))
        for joint in chain:
            pose = compose(pose, _joint_motion(joint, q[joint.letter], errors))
            found[joint.letter] = pose
        found[name] = pose
    return found


def tool_in_work(machine, poses):
    """Pose of the tool frame in W, and the tip in W."""
    relative = compose(inverse(poses["W"]), poses["T"])
    return relative, apply(relative, machine.tip)


# --- the machines that a trial may draw

def _axis(letter, direction, travel=None, offset=(0, 0, 0), rotary=False):
    text = {"axis": letter, "type": "rotary" if rotary else "linear", "direction": list(direction),
            "offset_mm": [float(v) for v in offset]}
    text.update({"continuous": True} if travel is None else {"travel": list(travel)})
    return text


def _text(identity, name, work, tool, tip=(0, 0, 0)):
    return {"format": "nineline-machine/1", "id": identity, "name": name, "workpiece_chain": work,
            "tool_chain": tool, "tool": {"tip_mm": [float(v) for v in tip], "axis": [0, 0, 1]}}


def _grinder(rng):
    headstock = (0, 0, round(rng.uniform(80, 220)))
    slide = (round(rng.uniform(-20, 20)), 0, round(rng.uniform(280, 460)))
    tip = (round(rng.uniform(-30, 30)), 0, round(rng.uniform(-40, 40)))
    return _text("b2-k3032", "thread grinder",
                 [_axis("Z", (0, 0, 1), (-400, 400)), _axis("C", (0, 0, 1), None, headstock, rotary=True)],
                 [_axis("X", (1, 0, 0), (-50, 350), slide)], tip)


def _mill(rng):
    half = int(rng.choice([400, 500]))
    span = (-half, half)
    return _text("generic-3axis", "three-axis mill",
                 [_axis("Y", (0, -1, 0), span), _axis("X", (-1, 0, 0), span, (0, 0, round(rng.uniform(0, 150))))],
                 [_axis("Z", (0, 0, 1), span, (0, 0, round(rng.uniform(200, 600))))],
                 (0, 0, -round(rng.uniform(80, 250))))


def _trunnion(rng):
    tool = [_axis(letter, np.eye(3)[k].tolist(), (-500, 500)) for k, letter in enumerate("XYZ")]
    return _text("trunnion-ac", "five-axis mill",
                 [_axis("A", (-1, 0, 0), (-120, 120), rotary=True),
                  _axis("C", (0, 0, -1), None, (0, 0, round(rng.uniform(-60, 60))), rotary=True)],
                 tool, (0, 0, -round(rng.uniform(50, 200))))


def _table(_rng):
    return _text("rotary-table", "rotary table", [_axis("C", (0, 0, 1), rotary=True)], [])


def _stage(_rng):
    return _text("linear-stage", "linear stage", [], [_axis("X", (1, 0, 0), (-1000, 1000))])


MACHINES = {"b2-k3032": _grinder, "generic-3axis": _mill, "trunnion-ac": _trunnion, "rotary-table": _table,
            "linear-stage": _stage}


def draw(identity, rng):
    """A machine of that kind with dimensions of its own, as a `Machine`; its text goes into model.json whole."""
    return Machine(MACHINES[identity](rng))
