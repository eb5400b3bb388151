"""Runs the program on a case as its user would: `discover` on the first campaign, `predict` on the fresh one.

`cli` is the program's path, or a function from arguments to stdout (the stand-ins of oracle.py).
"""

import json
import subprocess
import time

import judge

LIMIT_S = 600


class ProgramFailed(Exception):
    pass


def run(cli, *arguments):
    if callable(cli):
        return cli(arguments)
    done = subprocess.run([str(one) for one in (cli, *arguments)], capture_output=True, text=True, timeout=LIMIT_S)
    if done.returncode != 0:
        raise ProgramFailed(f"status {done.returncode}: {done.stderr.strip()[-300:]}")
    return done.stdout


def discover(cli, folder, threads=None):
    """The result record, and the seconds it took."""
    model, new = folder / "model.json", folder / "new.json"
    new.unlink(missing_ok=True)
    measured = sorted((folder / "first").glob("*.csv"))
    started = time.monotonic()
    options = ["--threads", threads] if threads else []
    text = run(cli, *options, "--json", "discover", "--model", model, *measured, "--out", new)
    seconds = time.monotonic() - started
    try:
        answer = json.loads(text)
    except json.JSONDecodeError as error:
        raise ProgramFailed(f"no JSON on stdout: {error}") from error
    (folder / "answer.json").write_text(json.dumps(answer, indent=1), encoding="utf-8")
    return answer, seconds


def mean_square(cli, model, folder, sigma):
    """Mean squared residual (in sigmas) of a model on the fresh, noise-free campaign."""
    total, count, out = 0.0, 0, folder / "predicted.csv"
    for file in sorted((folder / "fresh").glob("*.csv")):
        run(cli, "--quiet", "predict", "--model", model, file, "--out", out)
        one, n = judge.squares(out, sigma)
        total, count = total + one, count + n
    return total / max(count, 1)


def trial(cli, folder, threads=None):
    """Everything known about one case after the run."""
    truth = json.loads((folder / "truth.json").read_text(encoding="utf-8"))
    record = {key: truth[key] for key in ("seed", "category", "machine", "samples", "separable")}
    record["hidden_effects"] = truth["hidden"]
    try:
        answer, record["seconds"] = discover(cli, folder, threads)
        record["verdict"] = answer.get("verdict")
        record.update(judge.judge_names(truth, answer))
        record["own_closed_pct"] = answer.get("gap", {}).get("closed_pct")
        record["notes"] = len(answer.get("data_quality", []))
        if truth["category"] == "lookalike":
            record["lists_lookalike"] = judge.lists_lookalike(truth, answer)
        if truth["faults"]:
            record["fault"] = truth["faults"][0]["kind"]
            record["finds_fault"] = judge.finds_fault(truth["faults"][0], answer)
        if truth.get("artefact"):
            record.update(judge.judge_artefact(truth["artefact"], answer))
        record["where_right"] = judge.points_at_joint(truth, answer)
        before = mean_square(cli, folder / "model.json", folder, truth["sigma"])
        after = mean_square(cli, folder / "new.json", folder, truth["sigma"])
        record.update(before=before, after=after, closed_pct=judge.closed_pct(before, after))
    except (ProgramFailed, subprocess.TimeoutExpired, OSError, KeyError, ValueError) as error:
        record["failed"] = f"{type(error).__name__}: {error}"[:400]
    return record
