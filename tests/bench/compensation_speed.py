#!/usr/bin/env python3
"""Rows CO-2 and CO-3 of performance.md: time and memory of whole compensations.

compensation_speed.py NINELINE_CLI FOLDER BLOCKS...   [environment: ROUNDS=3, RS274=1]
For each count a three- and a five-axis program are written, compensated with a seeded model, and read by
LinuxCNC's rs274 in turn with it (counts up to a million); prints medians and the ratio of processor times.
"""
import os
import shutil
import statistics
import subprocess
import sys
import time

import bench_inputs


def measured(command, folder):
    """Wall seconds, processor seconds, peak MiB of one process and its children."""
    begin = time.monotonic()
    process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - begin
    if status != 0:
        sys.exit(f"{command[0]} ended with {os.waitstatus_to_exitcode(status)}")
    return wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def row(cli, folder, blocks, five, rounds):
    axes, machine = ("ACXYZ", "trunnion-ac") if five else ("XYZ", "generic-3axis")
    model, program = os.path.join(folder, f"m{five}.json"), os.path.join(folder, f"p{five}.ngc")
    bench_inputs.write_model(model, machine, axes)
    bench_inputs.write_program(program, blocks, five)
    ours, theirs = [], []
    compare = shutil.which("rs274") and blocks <= 1_000_000 and os.environ.get("RS274", "1") == "1"
    for _ in range(rounds):
        ours.append(measured([cli, "compensate", "--model", model, program, "--out", "out.ngc", "--quiet"], folder))
        if compare:
            theirs.append(measured(["rs274", "-g", program, "canon.txt"], folder))
    wall, cpu, peak = (statistics.median(column) for column in zip(*ours))
    text = (f"{5 if five else 3} axes, {blocks} blocks: wall {wall / blocks * 1e6:.2f} us, "
            f"processor {cpu / blocks * 1e6:.2f} us a block, peak {peak:.0f} MiB")
    if theirs:
        other = statistics.median(one[1] for one in theirs)
        text += f"; rs274 {other / blocks * 1e6:.2f} us, {other / wall:.2f} x our wall time"
    print(text, flush=True)
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    cli, folder = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    os.makedirs(folder, exist_ok=True)
    for count in sys.argv[3:]:
        blocks = int(count)
        rounds = 1 if blocks > 1_000_000 else int(os.environ.get("ROUNDS", "3"))
        for five in (False, True):
            row(cli, folder, blocks, five, rounds)


if __name__ == "__main__":
    main()
