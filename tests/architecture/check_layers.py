"""Holds every #include of core, ui and app against layers.json, and the way includes are written."""

import re
from pathlib import Path

import sources
from layers import Layers

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)
_STANDARD = re.compile(r"^[a-z_0-9]+$")
_QT = re.compile(r"^(Qt[A-Z][A-Za-z]*(/.*)?|Q[A-Z][A-Za-z0-9]*|Qt)$")


def qt_classes(headers):
    """Which Qt module a header belongs to, read from the installed headers: {'QAction': 'QtWidgets'}."""
    classes = {}
    for path in sorted(Path(headers).glob("Qt*/Q*")):
        if path.suffix == "":
            classes.setdefault(path.name, path.parent.name)
    return classes


class Checker:
    def __init__(self, root, layers, qt):
        self.root, self.layers, self.qt, self.faults = root, layers, qt, []

    def fault(self, path, line, text):
        self.faults.append(f"{path.relative_to(self.root)}:{line}: {text}")

    def check_file(self, path):
        text = path.read_text(encoding="utf-8")
        if path.suffix == ".h" and "#pragma once" not in text:
            self.fault(path, 1, "a header starts with #pragma once")
        for match in _INCLUDE.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            if match.group(1) == '"':
                self.own_include(path, line, match.group(2))
            else:
                self.library_include(path, line, match.group(2))

    def own_include(self, path, line, name):
        if name.endswith(".moc"):
            return
        if name.split("/")[0] not in ("core", "ui", "app", "tests") or ".." in name:
            return self.fault(path, line, f'"{name}": includes start at the root of the repository')
        if not (self.root / name).is_file():
            return self.fault(path, line, f'"{name}" does not exist')
        module = self.layers.module_of(path.relative_to(self.root))
        if module is None:
            return
        target = self.layers.module_of(name)
        if target not in self.layers.reachable(module):
            uses = ", ".join(sorted(self.layers.reachable(module) - {module})) or "nothing"
            self.fault(path, line, f'"{name}": {module} may include {uses}')

    def library_include(self, path, line, name):
        module = self.layers.module_of(path.relative_to(self.root))
        if name.startswith(("core/", "ui/", "app/", "tests/")):
            return self.fault(path, line, f"<{name}>: our own headers are included in quotes")
        if _QT.match(name) and "/" in name:
            return self.fault(path, line, f"<{name}>: Qt headers are included without module prefix")
        if module is None or self.is_free(name):
            return
        library = self.library_of(name)
        if library is None:
            return self.fault(path, line, f"<{name}>: this library is not in layers.json")
        if not self.layers.may_use_library(module, library, path.suffix == ".cpp"):
            if self.layers.may_use_library(module, library, True):
                return self.fault(path, line, f"<{name}>: {module} may use {library} in .cpp files only")
            self.fault(path, line, f"<{name}>: {module} may not use {library}")

    def is_free(self, name):
        table = self.layers.table
        return bool(_STANDARD.match(name)) or name.startswith(tuple(table["free_headers"] + table["system_headers"]))

    def library_of(self, name):
        for prefix, library in self.layers.table["headers"].items():
            if name.startswith(prefix):
                return library
        return self.qt.get(name, "an unknown Qt module") if _QT.match(name) else None


def check(root, qt_headers="", layers=None):
    layers = layers or Layers()
    checker = Checker(root, layers, qt_classes(qt_headers) if qt_headers else {})
    checker.faults += layers.cycles()
    for path in sources.cpp_files(root, "core", "ui", "app", "tests"):
        module = layers.module_of(path.relative_to(root))
        if module is not None and module not in layers.modules:
            checker.fault(path, 1, f"the module {module} is not in layers.json")
        checker.check_file(path)
    return checker.faults


if __name__ == "__main__":
    sources.run(check)
