#!/usr/bin/env python3
"""Gives nineline-cli every malformed file of malformed/cases.py and holds its answer against malformed/expected.txt.

Each must end in time with its status, with a message that names the file (and the line, where the fault has one), with
nothing on stdout and nothing written. A file that turns out harmless stands in expected.txt with status 0 and the reason.
Usage: check_malformed.py CLI [--show]
"""

import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent / "malformed"
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
import cases  # noqa: E402

TIMEOUT_S = 180
KINDS = {
    "nc": (cases.NC, "good.nc", ["compensate", "--model", "good-model.json", "bad", "--out", "out"]),
    "model": (cases.MODEL, "good-model.json", ["compensate", "--model", "bad", "good.nc", "--out", "out"]),
    "machine": (cases.MACHINE, "good-machine.json", ["machines", "bad"]),
    "thread": (cases.THREAD, "good-thread.json", ["thread", "--params", "bad", "--out", "out"]),
}


def changed(good, change):
    if callable(change):
        return change(good)
    lines = good.split(b"\n")
    lines[change[0] - 1] = change[1].encode()
    return b"\n".join(lines)


def expectations():
    """{'nc/axis_twice': (status, line or None)}"""
    found = {}
    for line in (HERE / "expected.txt").read_text(encoding="utf-8").splitlines():
        words = line.split("#")[0].split()
        if words:
            found[words[0]] = (int(words[1]), None if words[2] == "-" else int(words[2]))
    return found


def run(cli, arguments, text):
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        for _, good, _ in KINDS.values():
            (work / good).write_bytes((HERE / good).read_bytes())
        (work / "bad").write_bytes(text)
        present = {path.name for path in work.iterdir()}
        try:
            done = subprocess.run([cli, *arguments, "--quiet"], cwd=work, capture_output=True, timeout=TIMEOUT_S)
        except subprocess.TimeoutExpired:
            return None, "", "", set()
        left = {path.name for path in work.iterdir()} - present
        return done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace"), left


def place_of(message):
    """The line in the last 'error: bad:LINE:…'; None where none is named."""
    found = re.findall(r"^error: bad:(\d+)", message, re.M)
    return int(found[-1]) if found else None


def faults_of(answer, wanted):
    status, out, err, left = answer
    if status is None:
        yield f"did not end within {TIMEOUT_S} s"
        return
    if (status, place_of(err)) != wanted:
        yield f"status {status} at line {place_of(err)}, expected {wanted[0]} at line {wanted[1]}: {err[:300]!r}"
    if status != 0 and (out or left):
        yield f"left {sorted(left)} and {len(out)} characters on stdout"
    if status != 0 and not re.search(r"^error: bad[:\s]", err, re.M):
        yield f"does not name the file: {err[:300]!r}"
    if "itself" in err or len(err) > 20_000:
        yield f"a crash, or a flood: {err[:300]!r}"


def main():
    cli = str(pathlib.Path(sys.argv[1]).resolve())
    wanted = expectations()
    count, bad = 0, 0
    for kind, (changes, good, arguments) in KINDS.items():
        for name, change in changes:
            key = f"{kind}/{name}"
            answer = run(cli, arguments, changed((HERE / good).read_bytes(), change))
            if "--show" in sys.argv:
                print(f"{key} {answer[0]} {place_of(answer[2]) or '-'}  # {answer[2][:170]!r}")
            faults = list(faults_of(answer, wanted.pop(key, (3, "not listed"))))
            count, bad = count + 1, bad + bool(faults)
            for fault in faults if "--show" not in sys.argv else []:
                print(f"{key}: {fault}")
    for key in wanted:
        print(f"{key} is expected, but there is no such case")
    print(f"{count} malformed files, {bad} answered otherwise than expected")
    return 1 if bad or wanted or count < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
