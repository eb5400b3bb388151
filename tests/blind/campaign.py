"""Campaigns: which files of which instruments are taken on a machine, and under which conditions.

Every machine has one plan, whatever is hidden in it, so that a file's presence tells nothing. `Options` bends the plan
where a case needs it (one temperature only, one file per run, …). A fresh campaign has other places, feeds and
temperatures.
"""

import numpy as np

import machines
import states

LATERAL = {"X": "YZ", "Y": "ZX", "Z": "XY"}


class Options:
    def __init__(self, **changes):
        self.fresh = False            # the second campaign
        self.one_temperature = False  # every run at the same temperatures
        self.one_height = False       # dials at one height only
        self.linear_only = False      # one instrument only on each axis
        self.split_runs = False       # a file per run: effects with memory start anew
        self.__dict__.update(changes)


class File:
    """One measurement file: head, channels (deviation only), runs joined in `whole`, sigma per unit."""

    def __init__(self, name, instrument, head, runs, sigma, channels=()):
        self.name, self.instrument, self.head = name, instrument, head
        self.whole, self.sigma, self.channels = states.joined(runs), sigma, list(channels)
        self.readings = {}          # what the file shows, column by column
        self.undisturbed = None     # readings without noise and with nothing hidden, once they are computed

    def sigma_of(self, column):
        return self.sigma["arcsec" if column.endswith("arcsec") else "um"]


class Builder:
    def __init__(self, machine, rng, options, sigma):
        self.machine, self.rng, self.options, self.sigma = machine, rng, options, sigma
        self.climate = states.Climate(machine, rng, rng.uniform(8, 14), options.one_temperature)
        self.clock, self.files = 600.0, []
        self.range = rng.uniform(0.70, 0.85) if options.fresh else 0.92

    # --- conditions

    def _warmths(self, n):
        levels = np.linspace(0.0, 1.0, n) if n > 1 else np.array([self.rng.uniform(0, 1)])
        if self.options.fresh:
            levels = np.clip(levels + self.rng.normal(size=n) * 0.15, 0, 1)
        return self.rng.permutation(levels)

    def add(self, name, instrument, head, runs, factor=1.0, channels=()):
        sigma = {unit: value * factor for unit, value in self.sigma.items()}
        loads = self.rng.permutation(np.resize([0.0, 150.0, 300.0, 450.0], len(runs)))
        for run, warmth, k in zip(runs, self._warmths(len(runs)), range(len(runs))):
            self.climate.apply(run, warmth)
            run.load = np.full(run.n, float(loads[k]))
        groups = [[run] for run in runs] if self.options.split_runs else [runs]
        for k, group in enumerate(groups):
            suffix = f"-{k + 1}" if len(groups) > 1 else ""
            self.files.append(File(f"{len(self.files) + 1:02d}-{name}{suffix}", instrument, head, group, sigma,
                                   channels))

    def start(self, seconds, pause=None):
        """The start of a run of that length; the clock moves past it and a pause."""
        at = self.clock
        self.clock += seconds + (pause if pause is not None else self.rng.uniform(120, 900))
        return round(at, 1)

    def targets(self, letter, count):
        low, high = self.machine.joints[letter].travel
        middle, half = (low + high) / 2, self.range * (high - low) / 2
        nominal = np.linspace(middle - half, middle + half, count)
        step = nominal[1] - nominal[0]
        return np.round(nominal + self.rng.uniform(-0.25, 0.25, count) * step * (count > 3), 1)

    def parking(self, besides):
        """Places of the joints that stand still."""
        places = {}
        for one in self.machine.joints.values():
            if one.letter not in besides and one.linear:
                low, high = one.travel
                places[one.letter] = round((low + high) / 2 + self.rng.uniform(-0.15, 0.15) * (high - low))
        return places

    def point(self, letter):
        """Where a beam meets the moving body; levers differ from set-up to set-up."""
        return [float(round(v)) for v in self.rng.uniform(-220, 220, 3)]

    # --- instruments

    def line_runs(self, letter, count, runs, cycles=1):
        found, places = [], self.parking([letter])
        targets = self.targets(letter, count)
        for _ in range(runs):
            walk = states.pendulum(targets, cycles)
            run = states.stepped(self.machine, letter, walk, self.start(6.0 * len(walk)))
            run.feed = np.full(run.n, 3000.0)
            found.append(run.hold(**places))
        return found

    def laser_linear(self, letter, count=16, runs=4):
        self.add(f"laser-{letter}", "laser-linear", {"axis": letter, "point_mm": self.point(letter)},
                 self.line_runs(letter, count, runs))

    def straightness(self, letter, sensitive, count=14, runs=3):
        self.add(f"straightness-{letter}{sensitive}", "laser-straightness",
                 {"axis": letter, "sensitive": sensitive, "point_mm": self.point(letter)},
                 self.line_runs(letter, count, runs), 1.3)

    def angular(self, letter, about, count=14, runs=3):
        self.add(f"angular-{letter}{about}", "laser-angular", {"axis": letter, "about": about},
                 self.line_runs(letter, count, runs))

    def dense(self, letter, about=None):
        """A short stretch in fine uneven steps, for what repeats with the screw."""
        low, high = self.machine.joints[letter].travel
        begin = self.rng.uniform(low + 0.2 * (high - low), high - 0.3 * (high - low))
        walk = states.pendulum(np.round(begin + np.cumsum(self.rng.uniform(0.8, 2.4, 36)), 3))
        runs = []
        for _ in range(2):
            run = states.stepped(self.machine, letter, walk, self.start(3.0 * len(walk)), 3.0)
            run.feed = np.full(run.n, 3000.0)
            runs.append(run.hold(**self.parking([letter])))
        head = {"axis": letter, "about": about} if about else {"axis": letter, "point_mm": self.point(letter)}
        self.add(f"dense-{letter}", "laser-angular" if about else "laser-linear", head, runs)

    def contour(self, letter, samples=60):
        """Read while moving, at several feeds: the joint's own scale, or a laser where the joint's sense is turned."""
        one = self.machine.joints[letter]
        low, high = one.travel if one.linear else (-60.0, 60.0)
        feeds = self.rng.permutation([900, 2500, 5500] if not self.options.fresh else [1500, 4000])
        runs = []
        for feed in feeds:
            amplitude = self.rng.uniform(0.06, 0.14) * (high - low)
            run = states.oscillating(self.machine, letter, round(self.rng.uniform(-0.1, 0.1) * (high - low)
                                     + (low + high) / 2), round(amplitude), float(feed), self.start(60), samples)
            runs.append(run.hold(**self.parking([letter])))
        if one.is_reversed:
            self.add(f"moving-{letter}", "laser-linear", {"axis": letter, "point_mm": self.point(letter)}, runs)
        else:
            self.add(f"moving-{letter}", "joint", {"axis": letter}, runs)

    def ballbar(self, letters, samples=80):
        radius = float(self.rng.choice([100, 150]))
        parked = {**self.parking(letters), **{one.letter: 0.0 for one in self.machine.rotary_joints()}}
        middle = [round(sum(self.machine.joints[k].travel) / 2 + self.rng.uniform(-60, 60)) for k in letters]
        centre, signs = self._ballbar_frame(letters, middle, parked)
        runs = []
        for feed in ((1200.0, 3600.0) if not self.options.fresh else (2400.0,)):
            for clockwise in (False, True):
                runs.append(states.circle(self.machine, letters, middle, radius, feed, self.start(60, 60), samples,
                                          clockwise, signs).hold(**parked))
        head = {"centre_mm": [round(float(v), 4) for v in centre], "radius_mm": radius, "plane": "".join(letters)}
        self.add(f"ballbar-{''.join(letters)}", "ballbar", head, runs, 1.5)

    def _ballbar_frame(self, letters, middle, parked):
        """The circle's centre in W, and the sense in which each joint moves the tool there."""
        def tip(places):
            q = {k: np.array([float(places.get(k, 0.0))]) for k in self.machine.joints}
            return machines.tool_in_work(self.machine, machines.bodies(self.machine, q, machines.ErrorState(1)))[1][0]
        places = {**parked, **dict(zip(letters, middle))}
        centre = tip(places)
        moved = [tip({**places, k: places[k] + 1.0}) - centre for k in letters]
        return centre, [float(np.sign(m["XYZ".index(k)])) for m, k in zip(moved, letters)]

    def grid(self, channels, count=45, runs=4, rotary=()):
        """Deviations at scattered places, every joint coming from either side."""
        found = []
        for _ in range(runs):
            run = states.Run(self.machine, self.start(12.0 * count) + 12.0 * np.arange(count))
            for one in self.machine.joints.values():
                if one.linear:
                    low, high = one.travel
                    half = 0.5 * self.range * (high - low)
                    q = (low + high) / 2 + self.rng.uniform(-half, half, count)
                elif one.letter in rotary:
                    low, high = one.travel or (-180, 180)
                    q = self.rng.uniform(0.8 * low, 0.8 * high, count)
                else:
                    continue
                run.q[one.letter] = np.round(q, 1)
                run.s[one.letter], run.d[one.letter] = states.history(run.q[one.letter])
            run.moving = [k for k in self.machine.joints if np.ptp(run.q[k]) > 0]
            run.feed = np.full(count, 3000.0)
            found.append(run)
        self.add("volume", "deviation", {}, found, 1.2, channels)

    def watch(self, channels, count=100):
        """Hours at one place: room, head, coolant and what drifts."""
        runs = []
        for _ in range(2):
            t = self.start(95.0 * count) + 95.0 * np.arange(count)
            run = states.Run(self.machine, t).hold(**self.parking([]))
            runs.append(run)
        self.add("watch", "deviation", {}, runs, 1.0, channels)
        for file in self.files:
            if "watch" in file.name:
                self._wander(file)

    def _wander(self, file):
        """Livelier temperatures for the long watch: head by use, room by the door; coolant on and off."""
        t, n, rng = file.whole.t, file.whole.n, self.rng
        if self.options.one_temperature:
            return
        use = np.repeat(rng.integers(0, 2, n // 13 + 1), 13)[:n].astype(float)
        door = np.repeat(rng.normal(size=n // 17 + 1), 17)[:n]
        file.whole.temps["head"] = 20.5 + 9.0 * states.lagged(t, use, 1500.0)
        file.whole.temps["ambient"] = file.whole.temps["ambient"] + 1.6 * states.lagged(t, door, 700.0)
        file.whole.columns["coolant_1"] = np.repeat(rng.integers(0, 2, n // 23 + 1), 23)[:n].astype(float)

    def dial(self, letter, sensitive, point, runs=4, samples=40):
        found = []
        for k in range(runs):
            rate = (1 if k % 2 == 0 else -1) * self.rng.choice([3.0, 6.0])
            begin = {letter: 0.0 if rate > 0 else 720.0}
            run = states.uniform(self.machine, {letter: rate}, begin, abs(rate) * 60, self.start(240, 60),
                                 700.0 / abs(rate), samples)
            found.append(run.hold(**self.parking([letter])))
        self.add(f"dial-{letter}{sensitive}", "dial",
                 {"axis": letter, "point_mm": [float(v) for v in point], "sensitive": sensitive}, found, 0.8)

    def indexing(self, letter, runs=4):
        """A polygon and autocollimator, there and back; then a fine stretch for worm and encoder."""
        low, high = self.machine.joints[letter].travel or (0, 345)
        wide = np.arange(np.ceil(low), high + 1e-6, 11.0 if self.options.fresh else 15.0)
        fine = np.round(self.rng.uniform(0.1, 0.6) * high + np.cumsum(self.rng.uniform(0.2, 0.7, 45)), 3)
        found = []
        for k in range(runs):
            walk = states.pendulum(wide if k % 4 < 3 else fine)
            run = states.stepped(self.machine, letter, walk, self.start(5.0 * len(walk)), 5.0)
            run.feed = np.full(run.n, 1800.0)
            found.append(run.hold(**self.parking([letter])))
        self.add(f"indexing-{letter}", "joint", {"axis": letter}, found)

    def thread(self, pitch, hand="right", samples=72):
        turns, found = 6.0, []
        for rpm in ((2.0, 6.0) if not self.options.fresh else (4.0,)):
            for sense in (1, -1):
                rate = sense * rpm * 6.0
                length = pitch / 360.0 * (-1 if hand == "left" else 1)
                begin = {"C": 0.0 if sense > 0 else 360.0 * turns, "Z": -60.0}
                begin["Z"] += 0.0 if sense > 0 else turns * 360 * length
                run = states.uniform(self.machine, {"C": rate, "Z": rate * length}, begin, abs(rate * length) * 60,
                                     self.start(200, 60), 360 * turns / abs(rate), samples)
                found.append(run.hold(X=self.tool_reach()))
        self.add(f"lead-{pitch:g}", "lead", {"pitch_mm": pitch, "starts": 1, "hand": hand}, found)

    def tool_reach(self):
        """X for a thread of radius 30 mm."""
        slide = self.machine.joints["X"].offset[0] + self.machine.tip[0]
        return round(30.0 - slide + 0.0, 3)

    def passes(self, runs=3):
        """Parts ground one after another since dressing, at several feeds."""
        found = []
        for _ in range(runs):
            count = int(self.rng.integers(12, 18))
            run = states.Run(self.machine, self.start(120.0 * count) + 120.0 * np.arange(count))
            run.hold(X=round(self.rng.uniform(20, 120)), Z=round(self.rng.uniform(-50, 50)))
            run.wheel_pass = 1.0 + np.arange(count)
            run.feed = self.rng.choice([400.0, 800.0, 1200.0, 1600.0], count)
            found.append(run)
        self.add("passes", "deviation", {}, found, 1.0, ["dev_x_um", "dev_z_um"])
