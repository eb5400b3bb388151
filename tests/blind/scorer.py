"""Scores the trial's records against the rows of the acceptance table and writes them as Markdown."""

import figures

NAMED = ("single", "pair", "triple")


class Row:
    """One line: a share with counts, or a figure; `is_met` is None where there is nothing to judge."""

    def __init__(self, what, value, must, is_met):
        self.what, self.value, self.must, self.is_met = what, value, must, is_met


def _of(records, *categories):
    return [one for one in records if one["category"] in categories]


def _share(what, hits, must, at_least=True):
    """A share of cases; hits is a list of truth values, failures among them count as misses."""
    n, k = len(hits), sum(bool(one) for one in hits)
    if n == 0:
        return Row(what, "no case", _percent_goal(must, at_least), None)
    low, high = figures.interval(k, n)
    met = k / n >= must if at_least else k / n <= must
    return Row(what, f"{100 * k / n:.1f} % ({k}/{n}; 95 % interval {100 * low:.1f}…{100 * high:.1f})",
               _percent_goal(must, at_least), met)


def _percent_goal(must, at_least):
    if must is None:
        return ""
    return f"{'≥' if at_least else '≤'} {100 * must:g} %"


def _plain_share(what, hits):
    row = _share(what, hits, 0.0)
    row.must, row.is_met = "", None
    return row


def _figure(what, value, unit, must=None, at_least=True):
    goal = "" if must is None else f"{'≥' if at_least else '≤'} {must:g} {unit}"
    if value is None:
        return Row(what, "no case", goal, None)
    met = None if must is None else (value >= must if at_least else value <= must)
    return Row(what, f"{value:.1f} {unit}", goal, met)


def _named_right(one):
    return "failed" not in one and one["named_right"] == one["hidden"]


def _exact(one):
    return "failed" not in one and one["exact_set"]


def _name_rows(records):
    single, several, none = _of(records, "single"), _of(records, "pair", "triple"), _of(records, "null")
    return [_share("single effect named right (effect and joint), 4σ and more", [_named_right(o) for o in single],
                   0.95),
            _plain_share("— and nothing false beside it", [_exact(o) for o in single]),
            _share("pairs and triples: the exact set", [_exact(o) for o in several], 0.80),
            _plain_share("— pairs", [_exact(o) for o in _of(records, "pair")]),
            _plain_share("— triples", [_exact(o) for o in _of(records, "triple")]),
            _plain_share("single of 1.2 to 3.5σ named right", [_named_right(o) for o in _of(records, "small")]),
            _share("false names where nothing is missing", ["failed" in o or o["false_names"] for o in none], 0.02,
                   at_least=False)]


def _closing_rows(records):
    done = [o for o in _of(records, *NAMED) if o.get("closed_pct") is not None]
    closed = [o["closed_pct"] for o in done]
    lost = sum("failed" in o for o in _of(records, *NAMED))
    own = [o["own_closed_pct"] - o["closed_pct"] for o in done if o.get("own_closed_pct") is not None]
    return [_figure("gap closed on fresh data, median", figures.quantile(closed + [-100.0] * lost, 0.5), "%", 98),
            _figure("— lowest tenth", figures.quantile(closed + [-100.0] * lost, 0.1), "%", 80),
            _figure("own held-out figure against that truth, mean difference", figures.mean([abs(v) for v in own]),
                    "points", 5, False),
            _figure("— with its sign", figures.mean(own), "points")]


def _parameter_rows(records):
    errors = [pair for o in records if "failed" not in o and o["separable"] for pair in o["parameter_errors"]]
    every = [v is not None and v <= 2.0 for one in errors for v in one.values()]
    first = [v is not None and v <= 2.0 for one in errors for v in list(one.values())[:1]]
    return [_share("parameters within 2σ of the truth", every, 0.90), _plain_share("— sizes alone", first)]


def _unknown_rows(records):
    cases = _of(records, "unknown")
    says = [o.get("verdict") in ("unknown", "partly") for o in cases]
    closed = [o["closed_pct"] for o in cases if o.get("closed_pct") is not None]
    return [_share("outside the library: says unknown or partly", says, 0.90),
            _figure("— closed by the smooth correction, median", figures.quantile(closed, 0.5), "%", 70),
            _plain_share("— without a false name", ["failed" not in o and not o["false_names"] for o in cases])]


def _honesty_rows(records):
    right = sum(o.get("sure_right", 0) for o in records)
    false = sum(o.get("sure_false", 0) for o in records)
    looks = _of(records, "lookalike")
    listed = [o.get("lists_lookalike") for o in looks]
    return [_share("not separable: lists the look-alike instead of claiming", listed, 0.90),
            _share("named with confidence 0.9 and more: right", [True] * right + [False] * false, 0.95)]


def _fault_rows(records):
    cases, clean = _of(records, "fault"), [o for o in records if o["category"] != "fault" and "failed" not in o]
    rows = [_plain_share("data fault found", [o.get("finds_fault") for o in cases])]
    for kind in ("sign", "unit", "swap", "stuck"):
        rows.append(_plain_share(f"— {kind}", [o.get("finds_fault") for o in cases if o.get("fault") == kind]))
    return rows + [_plain_share("data called faulty without a fault", [o["notes"] > 0 for o in clean]),
                   _plain_share("false names beside a data fault", [o.get("false_names") for o in cases])]


def _artefact_rows(records):
    cases = [o for o in _of(records, "artefact") if "failed" not in o]
    return [_plain_share("measurement artefact named", [o["artefact_named"] for o in cases]),
            _plain_share("— or its file pointed at", [o["artefact_noted"] for o in cases]),
            _plain_share("— without another name beside it", [not o["false_names"] for o in cases]),
            _plain_share("`where` speaks of the right joint (one hidden thing)",
                         [o.get("where_right") for o in _of(records, "single", "unknown")])]


def _time_rows(records):
    scaled = [o["seconds"] * 2000.0 / o["samples"] for o in records if "seconds" in o]
    raw = [o["seconds"] for o in records if "seconds" in o]
    return [_figure("time for 2,000 samples, median", figures.quantile(scaled, 0.5), "s", 20, False),
            _figure("— of a case as it was, slowest", max(raw) if raw else None, "s"),
            _plain_share("program failed", ["failed" in o for o in records])]


def rows(records):
    return (_name_rows(records) + _closing_rows(records) + _parameter_rows(records) + _unknown_rows(records)
            + _honesty_rows(records) + _fault_rows(records) + _artefact_rows(records)
            + _time_rows(records))


def markdown(records, seeds):
    lines = [f"# Blind trial, seeds {seeds}", "", f"{len(records)} cases.", "",
             "| figure | reached | must | |", "|---|---|---|---|"]
    for row in rows(records):
        mark = "" if row.is_met is None else ("met" if row.is_met else "**missed**")
        lines.append(f"| {row.what} | {row.value} | {row.must} | {mark} |")
    lines += ["", "## By effect", "", "| effect | hidden | named | falsely named |", "|---|---|---|---|"]
    lines += [f"| {name} | {hidden} | {hidden - missed} | {false} |"
              for name, (hidden, missed, false) in sorted(_by_effect(records).items())]
    lines += ["", "## Not right", ""] + [_complaint(one) for one in records if not _is_right(one)]
    return "\n".join(lines) + "\n"


def _by_effect(records):
    table = {}
    for one in records:
        if "failed" in one or one["category"] not in NAMED + ("small", "null"):
            continue
        effects = [o["effect"] for o in one["hidden_effects"]]
        for k, names in enumerate((effects, one["missed"], one["false_names"])):
            for name in names:
                table.setdefault(name.split("@")[0], [0, 0, 0])[k] += 1
    return table


def _is_right(one):
    if "failed" in one:
        return False
    if one["category"] == "unknown":
        return one["verdict"] in ("unknown", "partly")
    if one["category"] == "lookalike":
        return one["lists_lookalike"]
    if one["category"] == "artefact":
        return one["artefact_noted"] and not one["false_names"]
    return one["exact_set"] and one.get("finds_fault", True)


def _complaint(one):
    if "failed" in one:
        return f"- seed {one['seed']} ({one['category']}, {one['machine']}): {one['failed']}"
    parts = [f"{o['effect']}{'/' + o['kind'] if 'kind' in o else ''}@{o['joint']} {o['component']} "
             f"{o['amplitude_sigma']:.1f}σ" for o in one["hidden_effects"]]
    hidden = ", ".join(parts) or one.get("artefact") or one.get("fault") or "nothing"
    names, closed = ", ".join(one["names"]) or "nothing", one.get("closed_pct")
    return (f"- seed {one['seed']} ({one['category']}, {one['machine']}): hidden {hidden}; verdict {one['verdict']}, "
            f"named {names}; closed {'–' if closed is None else f'{closed:.1f} %'}")
