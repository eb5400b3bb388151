// Fifty files with the faults of real life: each is read right, or refused with a message that names place
// and remedy. What the shop floor does to a file: half runs, decimal commas, GBK text, missing targets,
// swapped runs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/text.h"
#include "core/kinematics/machine_file.h"
#include "core/measurement/column_mapping.h"
#include "core/measurement/measurement_file.h"
#include "core/measurement/run_checks.h"
#include "tests/core/measurement/set_ups.h"

namespace nineline::measurement {
namespace {

const Machine& grinder() { return *kinematics::findBuiltInMachine("b2-k3032"); }

/// A campaign of a laser on Z: four runs there and back over 0…300 mm, as text by cells.
struct Sheet {
  std::vector<std::string> head = {"#nineline-measurement: 1",  "#machine: b2-k3032",
                                   "#instrument: laser-linear", "#axis: Z",
                                   "#point_mm: 0 0 0",          "#repeatability_um: 0.3"};
  std::vector<std::string> columns = {"run", "t_s", "Z_mm", "temp_bed_C", "dev_um"};
  std::vector<std::vector<std::string>> rows;
  std::string separator = ",";
  std::string line_end = "\n";

  Sheet() {
    test_support::Random random(350);
    for (int run = 1; run <= 4; ++run) {
      for (int i = 0; i <= 12; ++i) {
        const double z = run % 2 == 1 ? 25.0 * i : 300.0 - 25.0 * i;
        const double dev = 6.0 * std::sin(z / 70.0) + 0.01 * z + random.between(-0.2, 0.2);
        rows.push_back({std::to_string(run), std::to_string(10 * (13 * run + i)), fixed(z, 1),
                        fixed(20.0 + 0.01 * i, 2), fixed(dev, 2)});
      }
    }
  }

  [[nodiscard]] std::string text() const {
    std::string out;
    for (const std::string& line : head) out += line + line_end;
    const auto add = [&](const std::vector<std::string>& cells) {
      for (std::size_t i = 0; i < cells.size(); ++i) out += (i > 0 ? separator : "") + cells[i];
      out += line_end;
    };
    add(columns);
    for (const std::vector<std::string>& row : rows) add(row);
    return out;
  }
};

/// One file: how it was spoilt, and what has to be said of it. `said` empty: read without a word.
struct RealFile {
  std::string name;
  std::function<std::string(Sheet)> spoil;
  bool is_read = true;
  std::string said;      // part of a message
  std::size_t line = 0;  // where, for refusals
  std::size_t samples = 52;
};

RealFile reads(std::string name, std::function<std::string(Sheet)> spoil, std::string said = "",
               std::size_t samples = 52) {
  return {std::move(name), std::move(spoil), true, std::move(said), 0, samples};
}

RealFile refuses(std::string name, std::function<std::string(Sheet)> spoil, std::string said,
                 std::size_t line) {
  return {std::move(name), std::move(spoil), false, std::move(said), line, 0};
}

std::string utf16(const std::string& text, bool little) {
  std::string out = little ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : text) out += little ? std::string{c, '\0'} : std::string{'\0', c};
  return out;
}

/// Multiplies the readings of one run.
Sheet scaled(Sheet sheet, const std::string& run, double factor) {
  for (std::vector<std::string>& row : sheet.rows) {
    if (row[0] == run) row[4] = fixed(*parseNumber(row[4]) * factor, 5);
  }
  return sheet;
}

std::vector<RealFile> layouts() {
  return {
      reads("as it should be", [](const Sheet& s) { return s.text(); }),
      reads("semicolons",
            [](Sheet s) {
              s.separator = ";";
              return s.text();
            }),
      reads("tabs",
            [](Sheet s) {
              s.separator = "\t";
              return s.text();
            }),
      reads("CRLF",
            [](Sheet s) {
              s.line_end = "\r\n";
              return s.text();
            }),
      reads("old Macintosh line ends",
            [](Sheet s) {
              s.line_end = "\r";
              return s.text();
            }),
      reads("byte order mark", [](const Sheet& s) { return "\xEF\xBB\xBF" + s.text(); }),
      reads(
          "UTF-16 little end first", [](const Sheet& s) { return utf16(s.text(), true); }, "UTF-16"),
      reads(
          "UTF-16 big end first", [](const Sheet& s) { return utf16(s.text(), false); }, "UTF-16"),
      reads(
          "GBK operator",
          [](Sheet s) {
            s.head.push_back("#operator: \xD5\xC5\xC8\xFD");
            return s.text();
          },
          "GBK"),
      reads("blanks around cells",
            [](Sheet s) {
              s.separator = " , ";
              return s.text();
            }),
      reads("quoted cells",
            [](Sheet s) {
              for (auto& row : s.rows) row[4] = "\"" + row[4] + "\"";
              return s.text();
            }),
      reads("padded head",
            [](Sheet s) {
              for (auto& line : s.head) line += ",,,,";
              return s.text();
            }),
      reads("empty lines",
            [](Sheet s) {
              s.line_end = "\n\n";
              return s.text();
            }),
      reads("rows of separators at the end", [](const Sheet& s) { return s.text() + ",,,,\n,,,,\n"; }),
      reads("empty column at the end",
            [](Sheet s) {
              s.columns.emplace_back("");
              for (auto& row : s.rows) row.emplace_back("");
              return s.text();
            }),
      reads(
          "remark column",
          [](Sheet s) {
            s.columns.emplace_back("remark");
            for (auto& row : s.rows) row.emplace_back("ok");
            return s.text();
          },
          "left out"),
      reads("unknown numeric column",
            [](Sheet s) {
              s.columns.emplace_back("humidity_pct");
              for (auto& row : s.rows) row.emplace_back("45");
              return s.text();
            }),
      reads("comment between samples",
            [](Sheet s) {
              s.rows[5][0] = "# door opened\n" + s.rows[5][0];
              return s.text();
            }),
      reads("exponents and plus signs",
            [](Sheet s) {
              s.rows[0][4] = "+1.5e-1";
              return s.text();
            }),
      reads("no line end at the end",
            [](const Sheet& s) {
              std::string text = s.text();
              text.pop_back();
              return text;
            }),
  };
}

std::vector<RealFile> missing() {
  return {
      reads(
          "half a run",
          [](Sheet s) {
            s.rows.resize(45);
            return s.text();
          },
          "run 4 lacks 7 of the 13", 45),
      reads(
          "missing targets",
          [](Sheet s) {
            s.rows.erase(s.rows.begin() + 3, s.rows.begin() + 5);
            return s.text();
          },
          "run 1 lacks 2 of the 13", 50),
      reads(
          "missing readings",
          [](Sheet s) {
            s.rows[7][4].clear();
            return s.text();
          },
          "run 1 lacks 1 of the 13"),
      reads(
          "missing position",
          [](Sheet s) {
            s.rows[7][2].clear();
            return s.text();
          },
          "position is missing"),
      reads("sensor unplugged",
            [](Sheet s) {
              for (std::size_t i = 20; i < s.rows.size(); ++i) s.rows[i][3].clear();
              return s.text();
            }),
      reads(
          "a run pasted twice",
          [](Sheet s) {
            for (std::size_t i = 0; i < 13; ++i) s.rows[26 + i][4] = s.rows[i][4];
            return s.text();
          },
          "exactly the readings of run 1"),
      reads(
          "display frozen",
          [](Sheet s) {
            for (std::size_t i = 27; i < 37; ++i) s.rows[i][4] = "1.00";
            return s.text();
          },
          "stands still over 10 samples"),
      reads(
          "outside the travel",
          [](Sheet s) {
            s.rows[0][2] = "4000";
            return s.text();
          },
          "outside its travel"),
      reads(
          "another machine's axis",
          [](Sheet s) {
            s.columns[3] = "Y_mm";
            return s.text();
          },
          "names no axis"),
  };
}

std::vector<RealFile> mistakes() {
  return {
      reads(
          "one run with the wrong sign", [](const Sheet& s) { return scaled(s, "2", -1.0).text(); },
          "opposite sign"),
      reads(
          "one run in millimetres", [](const Sheet& s) { return scaled(s, "3", 1e-3).text(); },
          "about 0.001 times"),
      reads(
          "one run in nanometres", [](const Sheet& s) { return scaled(s, "3", 1e3).text(); },
          "about 1000 times"),
      reads(
          "one run in thousandths of an inch",
          [](const Sheet& s) { return scaled(s, "1", 1.0 / 25.4).text(); }, "about 0.03937 times"),
      reads(
          "one run of an inch instrument", [](const Sheet& s) { return scaled(s, "4", 25.4).text(); },
          "about 25.4 times"),
      reads(
          "one run in the opposite order",
          [](Sheet s) {
            for (std::size_t i = 0; i < 6; ++i) std::swap(s.rows[26 + i][4], s.rows[38 - i][4]);
            return s.text();
          },
          "backwards"),
  };
}

std::vector<RealFile> refusals() {
  return {
      refuses(
          "decimal commas between semicolons",
          [](Sheet s) {
            s.separator = ";";
            s.rows[0][4] = "0,5";
            return s.text();
          },
          "decimal point", 8),
      refuses(
          "decimal commas between commas",
          [](Sheet s) {
            s.rows[0][4] = "0,5";
            return s.text();
          },
          "decimal sign", 8),
      refuses(
          "not a number",
          [](Sheet s) {
            s.rows[1][4] = "NaN";
            return s.text();
          },
          "expected a number", 9),
      refuses(
          "overflow of a spreadsheet",
          [](Sheet s) {
            s.rows[1][4] = "#####";
            return s.text();
          },
          "'#####'", 9),
      refuses(
          "unit in the cell",
          [](Sheet s) {
            s.rows[2][4] = "1.5um";
            return s.text();
          },
          "'1.5um'", 10),
      refuses(
          "infinity",
          [](Sheet s) {
            s.rows[2][2] = "inf";
            return s.text();
          },
          "expected a number", 10),
      refuses(
          "row cut off",
          [](Sheet s) {
            s.rows.back().resize(3);
            return s.text();
          },
          "3 cells, expected 5", 59),
      refuses(
          "a word in a sensor column",
          [](Sheet s) {
            s.rows[4][3] = "dead";
            return s.text();
          },
          "temp_bed_C", 12),
      refuses(
          "degrees for a linear axis",
          [](Sheet s) {
            s.columns[2] = "Z_deg";
            return s.text();
          },
          "'Z_mm'", 7),
      refuses(
          "column twice",
          [](Sheet s) {
            s.columns[3] = "Z_mm";
            return s.text();
          },
          "twice", 7),
      refuses(
          "readings in another unit",
          [](Sheet s) {
            s.columns[4] = "dev_mm";
            return s.text();
          },
          "expected dev_um", 7),
      refuses(
          "no version",
          [](Sheet s) {
            s.head.erase(s.head.begin());
            return s.text();
          },
          "import", 1),
      refuses(
          "wrong axis",
          [](Sheet s) {
            s.head[3] = "#axis: Y";
            return s.text();
          },
          "Z, C, X", 4),
      refuses(
          "unknown instrument",
          [](Sheet s) {
            s.head[2] = "#instrument: laser";
            return s.text();
          },
          "laser-linear", 3),
      refuses(
          "point in two numbers",
          [](Sheet s) {
            s.head[4] = "#point_mm: 0 0";
            return s.text();
          },
          "x y z", 5),
      refuses(
          "nothing below the columns",
          [](Sheet s) {
            s.rows.clear();
            return s.text();
          },
          "No sample", 7),
      refuses(
          "half a run number",
          [](Sheet s) {
            s.rows[0][0] = "1.5";
            return s.text();
          },
          "whole number", 8),
      refuses(
          "bytes of a program", [](const Sheet& s) { return s.text() + std::string("\0\1\2", 3); }, "UTF-8",
          60),
      refuses(
          "empty file", [](const Sheet&) { return std::string(); }, "begin with", 1),
  };
}

/// All that is said about a file, by reader and run checks.
std::string saidOf(const MeasurementReading& reading) {
  std::string said;
  for (const Diagnostic& one : reading.diagnostics.all()) said += one.text + "\n";
  if (reading.diagnostics.hasErrors()) return said;
  for (const RunFault& fault : checkRuns(reading.measurement, grinder())) {
    EXPECT_FALSE(fault.remedy.empty());
    said += fault.text + "\n";
  }
  return said;
}

void expectRead(const RealFile& file, const MeasurementReading& reading, const std::string& said) {
  EXPECT_FALSE(reading.diagnostics.hasErrors()) << file.name << ": " << said;
  EXPECT_EQ(reading.measurement.samples.size(), file.samples) << file.name;
  if (file.said.empty()) {
    EXPECT_EQ(said, "") << file.name;
  } else {
    EXPECT_NE(said.find(file.said), std::string::npos) << file.name << ": " << said;
  }
  if (!file.said.empty()) return;
  const MeasurementReading wanted = readMeasurement(Sheet().text(), "wanted.csv");
  for (std::size_t i = 1; i < file.samples; ++i) {
    EXPECT_EQ(reading.measurement.readings[i], wanted.measurement.readings[i])
        << file.name << " sample " << i;
    EXPECT_EQ(reading.measurement.samples[i].q, wanted.measurement.samples[i].q)
        << file.name << " sample " << i;
  }
}

void expectRefused(const RealFile& file, const MeasurementReading& reading, const std::string& said) {
  ASSERT_TRUE(reading.diagnostics.hasErrors()) << file.name;
  EXPECT_EQ(reading.diagnostics.firstError("a.csv").line, file.line) << file.name << ": " << said;
  EXPECT_NE(said.find(file.said), std::string::npos) << file.name << ": " << said;
}

TEST(RealLife, FiftyFilesAreReadRightOrRefusedWithARemedy) {
  std::size_t count = 0;
  for (const std::vector<RealFile>& group : {layouts(), missing(), mistakes(), refusals()}) {
    for (const RealFile& file : group) {
      const MeasurementReading reading = readMeasurement(file.spoil(Sheet()), "a.csv");
      const std::string said = saidOf(reading);
      if (file.is_read) {
        expectRead(file, reading, said);
      } else {
        expectRefused(file, reading, said);
      }
      ++count;
    }
  }
  EXPECT_GE(count, 50u);
}

TEST(RealLife, AnyByteMayBeSpoilt) {
  // No input may crash the reader or slip a non-finite number through.
  test_support::Random random(351);
  const std::string good = Sheet().text();
  for (int k = 0; k < 3000; ++k) {
    std::string text = good;
    for (int n = random.whole(1, 6); n > 0; --n) {
      const auto at = static_cast<std::size_t>(random.whole(0, static_cast<int>(text.size()) - 1));
      if (random.whole(0, 2) == 0) {
        text.erase(at, static_cast<std::size_t>(random.whole(1, 40)));
      } else {
        text[at] = static_cast<char>(random.whole(0, 255));
      }
      if (text.empty()) break;
    }
    const MeasurementReading reading = readMeasurement(text, "a.csv");
    if (reading.diagnostics.hasErrors()) continue;
    for (const Sample& sample : reading.measurement.samples) {
      for (const double q : sample.q) ASSERT_TRUE(std::isfinite(q));
    }
    (void)checkRuns(reading.measurement, *reading.machine);
  }
}

}  // namespace
}  // namespace nineline::measurement
