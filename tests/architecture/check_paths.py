"""No path of one person's machine, and nothing at the top level that the layout does not know."""

import re

import sources

_MACHINE_PATH = re.compile(r"(?<![\w.~\-)}$*])/(?:work|farm|root|tmp|home/\w+|Users/\w+)/[\w.]")
_TOP = {"app", "core", "ui", "tests", "resources", "translations", "installer", "cmake"}
_TEXT = {".h", ".cpp", ".txt", ".cmake", ".json", ".md", ".sh", ".py", ".ts", ".qrc", ".qss", ".desktop", ".svg",
         ".nc", ".csv", ""}


def check(root):
    faults = [f"{path.name}: a folder that the layout does not know"
              for path in sorted(root.iterdir())
              if path.is_dir() and not path.name.startswith(".")
              and path.name not in _TOP | sources.SKIPPED]
    for path in sources.files(root):
        if path.suffix not in _TEXT:
            continue
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue  # bytes of a test case
        for number, line in enumerate(text.split("\n"), 1):
            match = _MACHINE_PATH.search(line)
            if match:
                faults.append(f"{path.relative_to(root)}:{number}: '{match.group(0)}…' is a path of one machine")
    return faults


if __name__ == "__main__":
    sources.run(check)
