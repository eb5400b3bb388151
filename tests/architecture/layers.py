"""The table of layers.json, ready to be asked."""

import json
from pathlib import Path

TABLE = Path(__file__).with_name("layers.json")


class Layers:
    def __init__(self, table=None):
        self.table = table or json.loads(TABLE.read_text(encoding="utf-8"))
        self.modules = self.table["modules"]

    def module_of(self, relative):
        """The module that a path of the repository belongs to; None outside the three layers."""
        parts = Path(relative).parts
        return "/".join(parts[:2]) if len(parts) > 2 and parts[0] in ("core", "ui", "app") else None

    def reachable(self, module):
        """The module itself and all that it may use, directly or through another."""
        found, waiting = set(), [module]
        while waiting:
            name = waiting.pop()
            if name in found:
                continue
            found.add(name)
            for used in self.modules.get(name, {}).get("uses", []):
                waiting += [used] if "/" in used else [m for m in self.modules if m.startswith(used + "/")]
        return found

    def may_use_library(self, module, library, in_cpp):
        rules = self.modules.get(module, {})
        return library in rules.get("libraries", []) or (in_cpp and library in rules.get("libraries_in_cpp", []))

    def cycles(self):
        """Modules that reach themselves through another one."""
        bad = []
        for module in self.modules:
            for used in self.reachable(module) - {module}:
                if module in self.reachable(used):
                    bad.append(f"{module} and {used} use each other")
        return bad
