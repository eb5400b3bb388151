#!/usr/bin/env python3
"""Output files of nineline-cli: whole or not at all, whatever happens while they are written.

A full disk is played by a limit on the size of files, a cancelled run by SIGINT at several moments. After each of
them the old output must be there byte for byte, and nothing beside it.
Usage: check_outputs.py CLI SOURCE_DIR
"""

import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

OLD = b"(AN OLDER PROGRAM)\n"
MODEL = "b2-k3032-model.json"


def long_program(blocks):
    """A thread-like program that takes a while."""
    lines = ["G21 G90", "G00 X24.000 Z0.000 C0.000", "G01 X23.080 F100.", "G93"]
    for k in range(blocks):
        lines.append(f"G01 Z{-(k % 200) * 0.0625:.3f} C{15.0 * (k % 20000):.3f} F60.")
    return "\n".join(lines) + "\n"


class Check:
    def __init__(self, cli, root):
        self.cli, self.root, self.faults = str(pathlib.Path(cli).resolve()), pathlib.Path(root), []

    def claim(self, holds, text):
        print(("ok   " if holds else "FAIL ") + text)
        if not holds:
            self.faults.append(text)

    def folder(self):
        work = pathlib.Path(tempfile.mkdtemp(prefix="nineline-"))
        for example in (self.root / "resources/examples").glob("*.json"):
            shutil.copy(example, work)
        (work / "out").mkdir()
        (work / "out" / "old").write_bytes(OLD)
        return work

    def untouched(self, work, what):
        left = {path.name: path.read_bytes() for path in (work / "out").iterdir()}
        self.claim(left == {"old": OLD}, f"{what}: the old file is untouched and alone ({sorted(left)})")

    def full_disk(self, arguments, program):
        """The disk takes 2000 bytes of a file, then no more."""
        work = self.folder()
        (work / "in.nc").write_text(program)

        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))

        done = subprocess.run([self.cli, *arguments, "--out", "out/old"], cwd=work, capture_output=True, text=True,
                              preexec_fn=limit, restore_signals=False, timeout=120)
        what = f"full disk, {arguments[0]}"
        self.claim(done.returncode == 3, f"{what}: status {done.returncode}")
        fault = done.stderr.splitlines()[-1]
        self.claim(fault.startswith("error: out/old: ") and fault.endswith("The old file is untouched."),
                   f"{what}: {fault}")
        self.claim(done.stdout == "", f"{what}: nothing on stdout")
        self.untouched(work, what)
        shutil.rmtree(work)

    def cancelled(self, arguments, program, first, stop):
        """Interrupted as soon as it has begun to write, and later."""
        work = self.folder()
        (work / "in.nc").write_text(program)
        run = subprocess.Popen([self.cli, *arguments, "--out", "out/old"], cwd=work, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60
        while len(list((work / "out").iterdir())) < 2 and run.poll() is None and time.monotonic() < deadline:
            time.sleep(0.005)
        time.sleep(first)
        run.send_signal(stop)
        out, err = run.communicate(timeout=60)
        what = f"cancelled after {first} s, {arguments[0]}"
        self.claim(run.returncode == 4, f"{what}: status {run.returncode}")
        self.claim(out == "" and "error: " in err, f"{what}: {err.strip()}")
        self.untouched(work, what)
        shutil.rmtree(work)

    def deaf_stdout(self):
        """A result that nobody takes is no success."""
        if not os.path.exists("/dev/full"):
            return
        with open("/dev/full", "wb") as full:
            done = subprocess.run([self.cli, "machines", "--json"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.claim(done.returncode == 3 and "standard output" in done.stderr, f"full stdout: {done.stderr.strip()}")

    def locked_folder(self):
        if os.geteuid() == 0:
            print("skip a folder without write permission: this user may write everywhere")
            return
        work = self.folder()
        (work / "in.nc").write_text(long_program(10))
        os.chmod(work / "out", 0o555)
        done = subprocess.run([self.cli, "compensate", "--model", MODEL, "in.nc", "--out", "out/old"], cwd=work,
                              capture_output=True, text=True)
        self.claim(done.returncode == 3 and "out/old" in done.stderr, f"locked folder: {done.stderr.strip()}")
        self.untouched(work, "locked folder")
        os.chmod(work / "out", 0o755)
        shutil.rmtree(work)


def main():
    check = Check(sys.argv[1], sys.argv[2])
    compensate = ["compensate", "--model", MODEL, "in.nc"]
    simulate = ["simulate", "--model", MODEL, "in.nc"]
    check.full_disk(compensate, long_program(500))
    check.full_disk(simulate, long_program(500))
    check.full_disk(["thread", "--params", "published-thread.json"], "")
    slow = long_program(400_000)
    check.cancelled(compensate, slow, 0.0, signal.SIGINT)
    check.cancelled(compensate, slow, 0.5, signal.SIGTERM)
    check.cancelled(simulate, slow, 0.0, signal.SIGINT)
    check.cancelled(simulate, slow, 0.5, signal.SIGINT)
    check.deaf_stdout()
    check.locked_folder()
    return 1 if check.faults else 0


if __name__ == "__main__":
    sys.exit(main())
