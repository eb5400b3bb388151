"""The files of the repository, and C++ text without its comments and literals."""

import re
import sys
from pathlib import Path

SKIPPED = {".git", "build", "out", ".cache", "__pycache__"}
CPP_ENDINGS = {".h", ".cpp"}

_LITERALS = re.compile(
    r'R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)"'  # raw text
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'"          # not a digit separator
    r"|//[^\n]*|/\*.*?\*/",
    re.S)


def files(root, *folders, endings=None):
    """Every file below the folders (all of them: the root), in a fixed order."""
    found = []
    for start in [root / folder for folder in folders] if folders else [root]:
        for path in start.rglob("*"):
            parts = path.relative_to(root).parts
            if SKIPPED.intersection(parts) or not path.is_file():
                continue
            if endings is None or path.suffix in endings:
                found.append(path)
    return sorted(found)


def cpp_files(root, *folders):
    return files(root, *folders, endings=CPP_ENDINGS)


def without_comments_and_literals(text):
    """The same lines; comments become blank, literals become empty ones."""
    def blank(match):
        token = match.group(0)
        lines = "\n" * token.count("\n")
        return lines if token.startswith("/") else '""' + lines
    return _LITERALS.sub(blank, text)


def without_preprocessor(text):
    """The same lines; directives, with their continuations, become blank."""
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: "\n" * m.group(0).count("\n"), text, flags=re.M)


def run(check):
    """What every check's main does: prints the faults and says how many there are."""
    root = Path(sys.argv[1]).resolve()
    faults = check(root, *sys.argv[2:])
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    sys.exit(1 if faults else 0)
