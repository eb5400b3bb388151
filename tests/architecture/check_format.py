"""clang-format leaves every source as it is. Its absence is a fault: packages.txt names it."""

import re
import shutil
import subprocess

import sources


def check(root, program="clang-format"):
    if shutil.which(program) is None:
        return [f"{program} is not installed"]
    paths = [str(path.relative_to(root)) for path in sources.cpp_files(root, "core", "ui", "app", "tests")]
    faults = set()
    for start in range(0, len(paths), 50):
        found = subprocess.run([program, "--dry-run", "--Werror", "--ferror-limit=1", *paths[start:start + 50]],
                               cwd=root, capture_output=True, text=True)
        if found.returncode != 0:
            places = re.findall(r"^(\S+:\d+):\d+: error", found.stderr, re.M)
            faults.update(f"{place}: clang-format would change this" for place in places)
            if not places:
                faults.add(found.stderr.strip())
    return sorted(faults)


if __name__ == "__main__":
    sources.run(check)
