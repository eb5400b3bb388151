"""The campaign of each machine, as a list of set-ups."""

import campaign


def _line_set(b, letter, wide=True):
    lateral = campaign.LATERAL[letter]
    if b.options.linear_only:
        b.laser_linear(letter, runs=5)
        return
    b.laser_linear(letter)
    b.dense(letter)
    b.contour(letter)
    for sensitive in lateral if wide else lateral[:1]:
        b.straightness(letter, sensitive)
        b.angular(letter, sensitive)
    if wide:
        b.angular(letter, letter, runs=2)
        b.dense(letter, about=lateral[0])


def stage(b):
    _line_set(b, "X")
    if b.options.linear_only:
        return
    b.grid(["dev_x_um", "dev_y_um", "dev_z_um"], 30)
    b.watch(["dev_x_um", "dev_y_um", "dev_z_um"])


def rotary_table(b):
    high = float(b.rng.uniform(180, 300))
    b.dial("C", "X", (0, 0, 40))
    if not b.options.one_height:
        b.dial("C", "X", (0, 0, round(high)))
        b.dial("C", "Y", (0, 0, round(high / 2)))
        b.dial("C", "Z", (round(b.rng.uniform(60, 120)), 0, 30))
    b.indexing("C", 6)
    b.contour("C")
    if not b.options.one_height:
        b.watch(["dev_x_um", "dev_y_um", "dev_z_um"])
        b.grid(["dev_z_um", "rot_z_arcsec"], 30, 4, rotary=("C",))


def grinder(b):
    for letter in "ZX":
        _line_set(b, letter, wide=letter == "Z")
    b.ballbar(("X", "Z"))
    if not b.options.one_height:
        b.dial("C", "X", (0, 0, 260))
        b.dial("C", "Z", (50, 0, 100))
    b.dial("C", "X", (0, 0, 420))
    b.indexing("C", 5)
    b.contour("C")
    b.thread(4.0 if not b.options.fresh else 6.0)
    b.thread(10.0, "left" if b.rng.random() < 0.3 else "right")
    b.passes()
    b.watch(["dev_x_um", "dev_y_um", "dev_z_um"])


def _mill(b, planes, rotary=()):
    letters = [one.letter for one in b.machine.linear_joints()]
    for letter in letters:
        _line_set(b, letter, wide=False)
    if b.options.linear_only:
        return
    for plane in planes:
        b.ballbar(plane)
    b.grid(["dev_x_um", "dev_y_um", "dev_z_um"], 45, 4, rotary)
    b.watch(["dev_x_um", "dev_y_um", "dev_z_um"])


def generic(b):
    _mill(b, (("X", "Y"), ("X", "Z")))


def trunnion(b):
    _mill(b, (("X", "Y"),), ("A", "C"))
    b.dial("C", "X", (0, 0, 60))
    if not b.options.one_height:
        b.dial("C", "X", (0, 0, 260))
        b.dial("C", "Z", (90, 0, 40))
    b.grid(["dev_x_um", "dev_y_um", "rot_z_arcsec"], 40, 3, ("A", "C"))


PLANS = {"b2-k3032": grinder, "generic-3axis": generic, "trunnion-ac": trunnion, "rotary-table": rotary_table,
         "linear-stage": stage}


def build(machine, rng, options, sigma):
    """All files of a campaign, with commanded positions and conditions but without readings."""
    builder = campaign.Builder(machine, rng, options, sigma)
    PLANS[machine.id](builder)
    return builder.files
