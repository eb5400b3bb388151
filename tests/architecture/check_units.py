"""Units are converted in core/base/units.h only: the numbers of a conversion stand nowhere else."""

import re

import sources

_HOME = "core/base/units.h"
_PI = r"(?:kPi|M_PI|pi|3\.14\d*)"
_RULES = [
    (re.compile(r"(?<![\w.])648000"), "arc seconds"),
    (re.compile(r"(?<![\w.])20626[45]"), "arc seconds"),
    (re.compile(r"(?<![\w.])4\.848\d*e-0?6"), "arc seconds"),
    (re.compile(r"(?<![\w.])25\.40*(?![\d.])"), "inches"),
    (re.compile(r"(?<![\w.])180(\.0*)?\s*/\s*(?:\w+::)*" + _PI), "degrees"),
    (re.compile(_PI + r"\s*/\s*180(?!\d)"), "degrees"),
    (re.compile(r"(?<![\w.])57\.29\d*"), "degrees"),
    (re.compile(r"(?<![\w.])0?\.01745\d*"), "degrees"),
    (re.compile(r"(?<![\w.])3\.14\d+"), "pi"),
    (re.compile(r"\bM_PI\b|\bnumbers::pi\b"), "pi"),
]


def check(root):
    faults = []
    for path in sources.cpp_files(root, "core", "ui", "app"):
        place = path.relative_to(root).as_posix()
        if place == _HOME:
            continue
        text = sources.without_comments_and_literals(path.read_text(encoding="utf-8"))
        for number, line in enumerate(text.split("\n"), 1):
            for pattern, what in _RULES:
                match = pattern.search(line)
                if match:
                    faults.append(f"{place}:{number}: '{match.group(0)}' ({what}): only {_HOME} converts units")
    return faults


if __name__ == "__main__":
    sources.run(check)
