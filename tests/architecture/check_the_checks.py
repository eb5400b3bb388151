"""Every check of this folder is given a small tree with a planted fault, and must name its place; and one without."""

import tempfile
import unittest
from pathlib import Path

import check_format
import check_layers
import check_paths
import check_sizes
import check_targets
import check_units
import sources

GOOD_HEADER = "#pragma once\n\nnamespace nineline {\nint one();\n}  // namespace nineline\n"


class PlantedFaults(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.put("core/base/text.h", GOOD_HEADER)
        self.put("core/errors/model.h", GOOD_HEADER)
        self.put("ui/pages/page.h", GOOD_HEADER)

    def put(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def expect(self, faults, *wanted):
        self.assertEqual(len(faults), len(wanted), "\n".join(faults))
        for parts in wanted:
            matching = [fault for fault in faults if all(part in fault for part in parts)]
            self.assertEqual(len(matching), 1, f"{parts} in\n" + "\n".join(faults))

    # layers

    def layers(self):
        headers = self.root / "build" / "qt"  # a folder that the walk leaves out
        for name in ("QtCore/QString", "QtCore/QtGlobal", "QtWidgets/QAction", "QtNetwork/QTcpSocket"):
            (headers / name).parent.mkdir(parents=True, exist_ok=True)
            (headers / name).touch()
        return check_layers.check(self.root, headers)

    def test_layers_without_fault(self):
        self.put("core/errors/model.cpp", '#include "core/errors/model.h"\n\n#include <fmt/format.h>\n\n'
                 '#include <vector>\n\n#include "core/base/text.h"\n')
        self.put("ui/pages/page.cpp", '#include <QAction>\n#include <QtGlobal>\n\n#include "core/errors/model.h"\n')
        self.expect(self.layers())

    def test_layers_upwards(self):
        self.put("core/base/text.cpp", '#include "core/errors/model.h"\n')
        self.put("core/errors/model.cpp", '// first\n#include "ui/pages/page.h"\n')
        self.expect(self.layers(), ["core/base/text.cpp:1", "core/base may include nothing"],
                    ["core/errors/model.cpp:2", "ui/pages/page.h", "core/errors may include core/base, core/kinematics"])

    def test_layers_libraries(self):
        self.put("core/errors/model.cpp", "#include <QString>\n#include <vtkActor.h>\n#include <boost/any.hpp>\n")
        self.put("core/base/text.h", "#pragma once\n#include <nlohmann/json.hpp>\n")
        self.put("ui/jobs/job.cpp", "#include <QAction>\n")
        self.put("ui/scene/scene.cpp", "#include <QString>\n")
        self.expect(self.layers(), ["core/errors/model.cpp:1", "QtCore"], ["core/errors/model.cpp:2", "vtk"],
                    ["core/errors/model.cpp:3", "not in layers.json"],
                    ["core/base/text.h:2", "in .cpp files only"], ["ui/jobs/job.cpp:1", "QtWidgets"],
                    ["ui/scene/scene.cpp:1", "QtCore"])

    def test_layers_way_of_writing(self):
        self.put("core/errors/model.cpp", '#include "model.h"\n#include "core/errors/gone.h"\n#include <core/base/text.h>\n')
        self.put("ui/pages/page.cpp", "#include <QtWidgets/QAction>\n")
        self.put("core/errors/model.h", "int x();\n")
        self.put("core/mystery/m.h", GOOD_HEADER)
        self.expect(self.layers(), ["model.cpp:1", "start at the root"], ["model.cpp:2", "does not exist"],
                    ["model.cpp:3", "in quotes"], ["page.cpp:1", "without module prefix"],
                    ["model.h:1", "#pragma once"], ["core/mystery/m.h:1", "not in layers.json"])

    # targets

    def test_targets_without_fault(self):
        self.put("core/base/text.cpp", "")
        self.put("core/base/CMakeLists.txt", "nineline_add_module(core base\n  SOURCES\n    text.cpp\n"
                 "  PUBLIC Eigen3::Eigen\n  PRIVATE fmt::fmt nlohmann_json::nlohmann_json\n)\n")
        self.expect(check_targets.check(self.root))

    def test_targets_with_faults(self):
        for name in ("core/base/text.cpp", "core/base/new.cpp"):
            self.put(name, "")
        self.put("core/base/CMakeLists.txt", "nineline_add_module(core base SOURCES text.cpp gone.cpp\n"
                 "  PUBLIC nlohmann_json::nlohmann_json Nineline::core::errors PRIVATE Qt::Core Boost::any)\n")
        self.put("tests/core/base/CMakeLists.txt",
                 "nineline_add_test(text_test SOURCES ../../../core/base/text.cpp)\n")
        self.expect(check_targets.check(self.root), ["new.cpp is not listed"], ["gone.cpp is listed"],
                    ["nlohmann", "PRIVATE"], ["core/base may not link Nineline::core::errors"],
                    ["may not link Qt::Core"], ["Boost::any is not in layers.json"],
                    ["text_test", "adds no source of the program"])

    # sizes

    def test_sizes_without_fault(self):
        body = "  f();\n" * 58
        self.put("core/base/text.cpp", "int one() {\n" + body + "}\n" + "const int kMany[] = {\n" + "  1,\n" * 70 + "};\n")
        self.expect(check_sizes.check(self.root))

    def test_sizes_of_files(self):
        self.put("core/base/text.h", "#pragma once\n" + "int a();\n" * 250)
        self.put("core/base/text.cpp", "int a();\n" * 401)
        self.expect(check_sizes.check(self.root), ["text.h:1", "251"], ["text.cpp:1", "401"])

    def test_sizes_of_functions(self):
        body = "  if (x) { f('{', \"}\"); } // }\n" * 60
        self.put("core/base/text.cpp",
                 "namespace a {\nstruct S {\n  int m() {\n" + body + "  }\n};\n"                    # line 3
                 "S::S(int x) : b_{x}, c_{2} {\n" + body + "}\n"                                    # line 66
                 "template <typename T>\nauto g(T x) -> T {\n" + body + "}\n"                       # line 128
                 "const auto kLambda = [](int x) {\n" + body + "};\n}\n")                           # line 191
        self.expect(check_sizes.check(self.root), ["text.cpp:3:", "62 lines", "m()"], ["text.cpp:66:", "S::S"],
                    ["text.cpp:128:", "g(T x)"], ["text.cpp:191:", "kLambda"])

    # units, paths, format

    def test_units(self):
        good = "// 25.4 and 180.0 / kPi in a comment\nconst char* t = \"25.4\"; double a = 125.4, b = 180.0, c = 2.25;\n"
        self.put("core/base/text.cpp", good)
        self.put("core/base/units.h", "#pragma once\nconstexpr double x = 25.4;\n")
        self.expect(check_units.check(self.root))
        self.put("core/errors/model.cpp", "double a = b * 25.4;\ndouble c = d * 180.0 / std::numbers::pi;\n"
                 "double e = f * (kPi / 180.0);\ndouble g = h / 206264.8;\n")
        places = {fault.split(":")[1] for fault in check_units.check(self.root)}
        self.assertEqual(places, {"1", "2", "3", "4"})

    def test_paths(self):
        self.put("README.md", "see ../work/x, a/tmp/b and https://example.org/home/them\n")
        self.expect(check_paths.check(self.root))
        self.put("core/base/text.cpp", "// one\nopen(\"" + "/tmp" + "/x\");\n")
        self.put("helpers/x.txt", "")
        self.expect(check_paths.check(self.root), ["core/base/text.cpp:2", "path of one machine"], ["helpers", "layout"])

    def test_format(self):
        self.put(".clang-format", "BasedOnStyle: Google\n")
        self.expect(check_format.check(self.root))
        self.put("core/base/text.cpp", "int one();\nint  two( );\n")
        self.expect(check_format.check(self.root), ["core/base/text.cpp:2"])
        self.expect(check_format.check(self.root, "no-such-clang-format"), ["is not installed"])

    def test_literals_are_blanked(self):
        text = "a = 1'000'000; b = 'x'; c = R\"(\n{)\"; /* {\n */ d = \"\\\"{\"; // {\n}"
        blank = sources.without_comments_and_literals(text)
        self.assertNotIn("{", blank)
        self.assertEqual(blank.count("\n"), text.count("\n"))
        self.assertIn("1'000'000", blank)


if __name__ == "__main__":
    unittest.main(argv=["check_the_checks"])
