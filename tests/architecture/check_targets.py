"""Holds the CMake targets against layers.json: what they link, and that their sources are all listed."""

import re
from pathlib import Path

import sources
from layers import Layers

_MODULE = re.compile(r"nineline_add_module\(\s*(\w+)\s+(\w+)(.*?)\)", re.S)
_EXECUTABLE = re.compile(r"add_executable\(\s*([\w-]+)(.*?)\)", re.S)
_LINK = re.compile(r"target_link_libraries\(\s*([\w-]+)(.*?)\)", re.S)
_TEST = re.compile(r"nineline_add_test\(\s*([\w.-]+)(.*?)\)", re.S)
_KEYWORDS = ("SOURCES", "PUBLIC", "PRIVATE", "INTERFACE", "LABELS", "LINK")


def arguments(text):
    """{'PUBLIC': ['fmt::fmt'], …}; what stands before the first keyword is under ''."""
    groups, key = {"": []}, ""
    for word in re.sub(r"#[^\n]*", "", text).split():
        if word in _KEYWORDS:
            key = word
            groups.setdefault(key, [])
        else:
            groups[key].append(word)
    return groups


class Checker:
    def __init__(self, root, layers):
        self.root, self.layers, self.faults = root, layers, []

    def link(self, place, module, target, public):
        if target in self.layers.table["free_targets"] or target.startswith("$<"):
            return
        own = re.match(r"^Nineline::(\w+)::(\w+)$", target)
        if own:
            used = f"{own.group(1)}/{own.group(2)}"
            if used not in self.layers.reachable(module) - {module}:
                self.faults.append(f"{place}: {module} may not link {target}")
            return
        library = self.library_of(target)
        if library is None:
            self.faults.append(f"{place}: the target {target} is not in layers.json")
        elif not self.layers.may_use_library(module, library, True):
            self.faults.append(f"{place}: {module} may not link {target}")
        elif public and not self.layers.may_use_library(module, library, False):
            self.faults.append(f"{place}: {module} links {target} PRIVATE, since only .cpp files may use it")

    def library_of(self, target):
        if target.startswith("Qt::"):
            return "Qt" + target[4:]
        if target.startswith("VTK::") or target == "${VTK_LIBRARIES}":
            return "vtk"
        return self.layers.table["targets"].get(target)

    def sources_listed(self, place, folder, listed):
        present = {path.relative_to(folder).as_posix() for path in folder.rglob("*.cpp")}
        for name in sorted(present - set(listed)):
            self.faults.append(f"{place}: {name} is not listed among the sources")
        for name in listed:
            if not (folder / name).is_file() and "$" not in name:
                self.faults.append(f"{place}: {name} is listed and does not exist")

    def module(self, path):
        text, place = path.read_text(encoding="utf-8"), path.relative_to(self.root)
        module = place.parent.as_posix()
        for layer, name, rest in _MODULE.findall(text):
            if f"{layer}/{name}" != module:
                self.faults.append(f"{place}: the target {layer} {name} belongs into {layer}/{name}")
            groups = arguments(rest)
            for key in ("PUBLIC", "PRIVATE"):
                for target in groups.get(key, []):
                    self.link(place, module, target, key == "PUBLIC")
            self.sources_listed(place, path.parent, groups.get("SOURCES", []))
        for _, rest in _LINK.findall(text):
            for key, targets in arguments(rest).items():
                for target in targets:
                    self.link(place, module, target, key == "PUBLIC" and not module.startswith("app/"))

    def test(self, path):
        text, place = path.read_text(encoding="utf-8"), path.relative_to(self.root)
        for pattern in (_TEST, _EXECUTABLE):
            for name, rest in pattern.findall(text):
                for word in arguments(rest).get("SOURCES", []) + arguments(rest)[""]:
                    if re.search(r"(^|/)(core|ui|app)/", word) and "tests/" not in word:
                        self.faults.append(f"{place}: {name} compiles {word}; a test adds no source of the program")


def check(root, layers=None):
    checker = Checker(root, layers or Layers())
    for path in sources.files(root, "core", "ui", "app", endings={".txt"}):
        if path.name == "CMakeLists.txt" and len(path.relative_to(root).parts) > 2:
            checker.module(path)
    for path in sources.files(root, "tests", endings={".txt"}):
        if path.name == "CMakeLists.txt":
            checker.test(path)
    return checker.faults


if __name__ == "__main__":
    sources.run(check)
