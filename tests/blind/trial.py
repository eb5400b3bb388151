#!/usr/bin/env python3
"""The blind trial of the model-gap workflow.

python3 tests/blind/trial.py --cli PATH --seeds A:B [--categories single,null] [--jobs 2] [--minutes M] --out FOLDER

Draws a case from every seed of A…B-1 (machine, noisy baseline model, campaign, hidden effects), lets the program look
for what is missing, judges its answer, and writes FOLDER/trial.md and FOLDER/records.json. Seeds 1 to 9999 are for
development; those from 50000 on are kept for reported figures. --generate-only writes the cases and runs nothing.
"""

import argparse
import concurrent.futures
import json
import pathlib
import shutil
import sys
import time

import cases
import oracle
import runner
import scorer


def _arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cli", help="the nineline-cli to be tried; `oracle` and `nothing` are stand-ins")
    parser.add_argument("--seeds", required=True, help="A:B, B not included; several ranges joined by commas")
    parser.add_argument("--categories", help="only these, by comma: " + " ".join(cases.CATEGORIES))
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--threads", type=int, help="--threads of the program")
    parser.add_argument("--minutes", type=float, help="begin no further case after so long")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--keep", action="store_true", help="keep the files of every case")
    parser.add_argument("--generate-only", action="store_true")
    parser.add_argument("--require", help="FIGURE=SHARE,… for an exit status: named, false, unknown, failed")
    return parser.parse_args()


def seeds_of(text, categories):
    wanted = categories.split(",") if categories else list(cases.CATEGORIES)
    unknown = set(wanted) - set(cases.CATEGORIES)
    if unknown:
        raise SystemExit(f"no such category: {', '.join(sorted(unknown))}")
    found = []
    for part in text.split(","):
        first, last = (int(one) for one in part.split(":"))
        found += [seed for seed in range(first, last) if cases.category_of(seed) in wanted]
    return found


def one_case(seed, options):
    """Draws, writes, runs and judges one case; its record."""
    folder = options.out / f"case-{seed}"
    shutil.rmtree(folder, ignore_errors=True)
    case = cases.draw(seed)
    cases.write(case, folder)
    if options.generate_only:
        return {"seed": seed, "category": case.category, "machine": case.machine.id}
    stand_in = options.cli in ("oracle", "nothing")
    cli = oracle.StandIn(options.cli == "oracle") if stand_in else pathlib.Path(options.cli)
    record = runner.trial(cli, folder, options.threads)
    if not options.keep:
        shutil.rmtree(folder, ignore_errors=True)
    return record


def _all(seeds, options):
    deadline = time.monotonic() + 60.0 * options.minutes if options.minutes else None
    records = []
    with concurrent.futures.ProcessPoolExecutor(max_workers=options.jobs) as pool:
        waiting, left = {}, list(seeds)
        while left or waiting:
            while left and len(waiting) < options.jobs and (deadline is None or time.monotonic() < deadline):
                seed = left.pop(0)
                waiting[pool.submit(one_case, seed, options)] = seed
            if not waiting:
                break
            done, _ = concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in done:
                waiting.pop(future)
                records.append(future.result())
                print(_progress(records[-1]), file=sys.stderr, flush=True)
    return sorted(records, key=lambda one: one["seed"])


def _progress(one):
    head = f"seed {one['seed']} {one['category']} {one['machine']}"
    if "failed" in one:
        return f"{head}: FAILED {one['failed']}"
    if "verdict" not in one:
        return head
    closed = one.get("closed_pct")
    return (f"{head}: {one['verdict']}; named {one['names']}, missed {one['missed']}, false {one['false_names']}; "
            f"closed {'-' if closed is None else round(closed, 1)} %; {one['seconds']:.1f} s")


def _shares(records):
    """The few shares that a short run in CI is held to."""
    def share(hits):
        return sum(hits) / len(hits) if hits else None
    alive = [one for one in records if "failed" not in one]
    return {"failed": share(["failed" in one for one in records]),
            "named": share([one["named_right"] == one["hidden"] for one in alive if one["category"] == "single"]),
            "false": share([bool(one["false_names"]) for one in alive if one["category"] in ("null", "single")]),
            "unknown": share([one["verdict"] in ("unknown", "partly")
                              for one in alive if one["category"] == "unknown"])}


def falls_short(records, required):
    """Sentences about the required shares that were not reached: named and unknown at least, the others at most."""
    shares, complaints = _shares(records), []
    for item in required.split(","):
        name, limit = item.split("=")
        value = shares[name]
        sense = 1.0 if name in ("named", "unknown") else -1.0
        if value is None or sense * value < sense * float(limit):
            complaints.append(f"{name}: {value} against the required {limit}")
    return complaints


def main():
    options = _arguments()
    if options.cli is None and not options.generate_only:
        raise SystemExit("--cli is needed, or --generate-only")
    options.out.mkdir(parents=True, exist_ok=True)
    records = _all(seeds_of(options.seeds, options.categories), options)
    if options.generate_only:
        return 0
    (options.out / "records.json").write_text(json.dumps(records, indent=1), encoding="utf-8")
    (options.out / "trial.md").write_text(scorer.markdown(records, options.seeds), encoding="utf-8")
    print((options.out / "trial.md").read_text(encoding="utf-8"))
    complaints = falls_short(records, options.require) if options.require else []
    for one in complaints:
        print(one, file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
