#!/usr/bin/env python3
"""Runs the golden cases of nineline-cli: tests/app/<command>/<case>/, a folder each.

args       the arguments, as a shell would split them; lines that begin with # are comments
inputs     whatever else lies in the folder is copied beside tests/app/inputs and resources/examples/*.json
expected/  status, stdout (or stdout.json), stderr, and files/: what the command must leave behind

What is not in expected/ must not be there: an empty stdout, no further file. An input must come out of the run as it
went in, unless expected/files names it. Text is compared exactly; JSON and CSV number by number.
Usage: run_cases.py CLI SOURCE_DIR [--update] [CASE...]
"""

import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

RELATIVE, ABSOLUTE = 1e-6, 2e-6
UNTESTED_KEYS = {"seconds"}  # the clock
TIMEOUT_S = 120


def near(found, wanted):
    return abs(found - wanted) <= ABSOLUTE + RELATIVE * abs(wanted)


def json_faults(found, wanted, place="result"):
    if isinstance(wanted, dict) and isinstance(found, dict):
        for key in sorted(wanted.keys() | found.keys()):
            if key in UNTESTED_KEYS:
                continue
            if key not in found or key not in wanted:
                yield f"{place}.{key} is {'missing' if key not in found else 'new'}"
            else:
                yield from json_faults(found[key], wanted[key], f"{place}.{key}")
    elif isinstance(wanted, list) and isinstance(found, list) and len(wanted) == len(found):
        for number, (one, other) in enumerate(zip(found, wanted)):
            yield from json_faults(one, other, f"{place}[{number}]")
    elif isinstance(wanted, (int, float)) and isinstance(found, (int, float)) and not isinstance(wanted, bool):
        if not near(found, wanted):
            yield f"{place} is {found}, expected {wanted}"
    elif found != wanted:
        yield f"{place} is {found!r}, expected {wanted!r}"


def same_cell(one, other):
    try:
        return near(float(one), float(other))
    except ValueError:  # an empty cell or a text
        return one == other


def csv_faults(found, wanted):
    rows, wanted_rows = found.splitlines(), wanted.splitlines()
    if len(rows) != len(wanted_rows) or rows[:1] != wanted_rows[:1]:
        return [f"{len(rows)} rows of other columns or count, expected {len(wanted_rows)}"]
    for number, (row, other) in enumerate(zip(rows[1:], wanted_rows[1:]), 2):
        for one, two in zip(row.split(","), other.split(",")):
            if not same_cell(one, two):
                return [f"row {number}: {one}, expected {two}"]
    return []


def text_faults(name, found, wanted):
    if name.endswith(".json"):
        return list(json_faults(json.loads(found), json.loads(wanted)))
    if name.endswith(".csv"):
        return csv_faults(found.decode(), wanted.decode())
    if found == wanted:
        return []
    for number, (one, two) in enumerate(zip(found.split(b"\n"), wanted.split(b"\n")), 1):
        if one != two:
            return [f"line {number} is {one!r}, expected {two!r}"]
    return [f"{len(found)} bytes, expected {len(wanted)}"]


def files_below(folder):
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class Case:
    def __init__(self, cli, root, folder):
        self.cli, self.root, self.folder = cli, root, folder
        self.name = folder.relative_to(root / "tests/app").as_posix()
        self.expected = folder / "expected"

    def arguments(self):
        lines = (self.folder / "args").read_text(encoding="utf-8").splitlines()
        return shlex.split(" ".join(line for line in lines if not line.startswith("#")))

    def prepare(self, work):
        shutil.copytree(self.root / "tests/app/inputs", work, dirs_exist_ok=True)
        for example in (self.root / "resources/examples").glob("*.json"):
            shutil.copy(example, work)
        for item in self.folder.iterdir():
            if item.name in ("args", "expected"):
                continue
            (shutil.copytree if item.is_dir() else shutil.copy)(item, work / item.name)

    def run(self):
        """{'status': …, 'stdout': …, 'stderr': …, 'files/…': …}: all that the command said and left."""
        with tempfile.TemporaryDirectory() as name:
            work = pathlib.Path(name)
            self.prepare(work)
            before = files_below(work)
            done = subprocess.run([self.cli, *self.arguments()], cwd=work, capture_output=True,
                                  stdin=subprocess.DEVNULL, timeout=TIMEOUT_S)
            after = files_below(work)
        found = {"status": b"%d\n" % done.returncode, "stdout": done.stdout, "stderr": done.stderr}
        if "--json" in self.arguments() and done.returncode == 0:
            found["stdout.json"] = found.pop("stdout")
        for path in before.keys() | after.keys():
            if before.get(path) != after.get(path):
                found[f"files/{path}"] = after.get(path, b"(gone)")
        return {key: text for key, text in found.items() if text}

    def check(self):
        found, wanted = self.run(), files_below(self.expected)
        faults = []
        for key in sorted(found.keys() | wanted.keys()):
            if key not in wanted:
                faults.append(f"{key} was not expected: {found[key][:300]!r}")
            elif key not in found:
                faults.append(f"{key} is missing")
            else:
                faults += [f"{key}: {fault}" for fault in text_faults(key, found[key], wanted[key])]
        return faults

    def update(self):
        found = self.run()
        shutil.rmtree(self.expected, ignore_errors=True)
        for key, text in found.items():
            path = self.expected / key
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text)


def main():
    cli, root = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    update = "--update" in sys.argv
    chosen = [name for name in sys.argv[3:] if name != "--update"]
    cases = [Case(pathlib.Path(cli).resolve(), root, path.parent) for path in sorted((root / "tests/app").glob("*/*/args"))]
    cases = [case for case in cases if not chosen or any(case.name.startswith(name) for name in chosen)]
    bad = 0
    for case in cases:
        if update:
            case.update()
            continue
        faults = case.check()
        bad += bool(faults)
        for fault in faults:
            print(f"{case.name}: {fault}")
    print(f"{len(cases)} cases, {bad} failed" if not update else f"{len(cases)} cases updated; read the diff")
    return 1 if bad or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
