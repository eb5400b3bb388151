#include "tests/core/measurement/real_life_files.h"

#include <cmath>
#include <functional>

#include "core/base/text.h"
#include "core/base/units.h"
#include "tests/support/random_machines.h"

namespace nineline::measurement {

namespace {

/// The campaign as text by cells. Rows begin in line 8.
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

using Edit = std::function<void(Sheet&)>;

std::string edited(const Edit& edit) {
  Sheet sheet;
  edit(sheet);
  return sheet.text();
}

RealFile reads(std::string name, std::string text, std::string said = "", std::size_t samples = 52) {
  return {std::move(name), std::move(text), true, std::move(said), 0, samples};
}
RealFile refuses(std::string name, std::size_t line, std::string said, std::string text) {
  return {std::move(name), std::move(text), false, std::move(said), line, 0};
}

std::string separatedBy(const std::string& separator) {
  return edited([&](Sheet& s) { s.separator = separator; });
}
std::string endingIn(const std::string& line_end) {
  return edited([&](Sheet& s) { s.line_end = line_end; });
}
std::string withCell(std::size_t row, std::size_t column, const std::string& cell) {
  return edited([&](Sheet& s) { s.rows[row][column] = cell; });
}
std::string withHead(std::size_t line, const std::string& text) {
  return edited([&](Sheet& s) { s.head[line] = text; });
}
std::string withName(std::size_t column, const std::string& name) {
  return edited([&](Sheet& s) { s.columns[column] = name; });
}
std::string withColumn(const std::string& name, const std::string& cell) {
  return edited([&](Sheet& s) {
    s.columns.push_back(name);
    for (std::vector<std::string>& row : s.rows) row.push_back(cell);
  });
}
std::string withRows(const std::function<void(std::vector<std::vector<std::string>>&)>& edit) {
  return edited([&](Sheet& s) { edit(s.rows); });
}
/// The readings of one run times a factor.
std::string scaled(const std::string& run, double factor) {
  return edited([&](Sheet& s) {
    for (std::vector<std::string>& row : s.rows) {
      if (row[0] == run) row[4] = fixed(*parseNumber(row[4]) * factor, 5);
    }
  });
}
std::string utf16(bool little) {
  std::string out = little ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : soundFile()) out += little ? std::string{c, '\0'} : std::string{'\0', c};
  return out;
}

std::vector<RealFile> layouts() {
  std::string open_end = soundFile();
  open_end.pop_back();
  return {
      reads("as it should be", soundFile()),
      reads("semicolons", separatedBy(";")),
      reads("tabs", separatedBy("\t")),
      reads("blanks around cells", separatedBy(" , ")),
      reads("CRLF", endingIn("\r\n")),
      reads("old Macintosh line ends", endingIn("\r")),
      reads("empty lines", endingIn("\n\n")),
      reads("byte order mark", "\xEF\xBB\xBF" + soundFile()),
      reads("UTF-16, little end first", utf16(true), "UTF-16"),
      reads("UTF-16, big end first", utf16(false), "UTF-16"),
      reads("GBK operator", edited([](Sheet& s) { s.head.push_back("#operator: \xD5\xC5\xC8\xFD"); }), "GBK"),
      reads("quoted cell", withRows([](auto& rows) { rows[3][4] = "\"" + rows[3][4] + "\""; })),
      reads("padded head", withHead(2, "#instrument: laser-linear,,,,")),
      reads("quoted head", withHead(2, "\"#instrument: laser-linear\"")),
      reads("rows of separators at the end", soundFile() + ",,,,\n,,,,\n"),
      reads("empty column at the end", withColumn("", "")),
      reads("remark column", withColumn("remark", "ok"), "left out"),
      reads("unknown numeric column", withColumn("humidity_pct", "45")),
      reads("comment between samples",
            withRows([](auto& rows) { rows[5][0] = "# door opened\n" + rows[5][0]; })),
      reads("plus signs and exponents", withCell(0, 4, "+1.5e-1")),
      reads("no line end at the end", open_end),
  };
}

std::vector<RealFile> missing() {
  return {
      reads("half a run", withRows([](auto& rows) { rows.resize(45); }), "run 4 lacks 7 of the 13", 45),
      reads("missing targets", withRows([](auto& rows) { rows.erase(rows.begin() + 3, rows.begin() + 5); }),
            "run 1 lacks 2 of the 13", 50),
      reads("missing reading", withCell(7, 4, ""), "run 1 lacks 1 of the 13"),
      reads("missing position", withCell(7, 2, ""), "position is missing"),
      reads("sensor unplugged", withRows([](auto& rows) {
              for (std::size_t i = 20; i < rows.size(); ++i) rows[i][3].clear();
            })),
      reads("a run pasted twice", withRows([](auto& rows) {
              for (std::size_t i = 0; i < 13; ++i) rows[26 + i][4] = rows[i][4];
            }),
            "exactly the readings of run 1"),
      reads("display frozen", withRows([](auto& rows) {
              for (std::size_t i = 27; i < 37; ++i) rows[i][4] = "1.00";
            }),
            "stands still over 10 samples"),
      reads("outside the travel", withCell(0, 2, "4000"), "outside its travel"),
      reads("another machine's axis", withName(3, "Y_mm"), "names no axis"),
  };
}

std::vector<RealFile> mistakes() {
  return {
      reads("one run with the wrong sign", scaled("2", -1.0), "dev_um of run 2 has the opposite sign"),
      reads("one run in millimetres", scaled("3", 1e-3), "run 3 is about 0.001 times"),
      reads("one run in nanometres", scaled("3", 1e3), "run 3 is about 1000 times"),
      reads("one run in mil", scaled("1", 1.0 / kMillimetresPerInch), "run 1 is about 0.03937 times"),
      reads("one run of an inch instrument", scaled("4", kMillimetresPerInch), "run 4 is about 25.4 times"),
      reads("one run in the opposite order", withRows([](auto& rows) {
              for (std::size_t i = 0; i < 6; ++i) std::swap(rows[26 + i][4], rows[38 - i][4]);
            }),
            "backwards"),
  };
}

std::vector<RealFile> wrongCells() {
  const std::string german = edited([](Sheet& s) {
    s.separator = ";";
    s.rows[0][4] = "0,5";
  });
  return {
      refuses("decimal commas between semicolons", 8, "decimal point", german),
      refuses("decimal commas between commas", 8, "decimal sign", withCell(0, 4, "0,5")),
      refuses("not a number", 9, "expected a number", withCell(1, 4, "NaN")),
      refuses("overflow of a spreadsheet", 9, "'#####'", withCell(1, 4, "#####")),
      refuses("unit in the cell", 10, "'1.5um'", withCell(2, 4, "1.5um")),
      refuses("infinity", 10, "expected a number", withCell(2, 2, "inf")),
      refuses("row cut off", 59, "3 cells, expected 5", withRows([](auto& rows) { rows.back().resize(3); })),
      refuses("a word in a sensor column", 12, "temp_bed_C", withCell(4, 3, "dead")),
      refuses("half a run number", 8, "whole number", withCell(0, 0, "1.5")),
      refuses("nothing below the columns", 7, "No sample", withRows([](auto& rows) { rows.clear(); })),
      refuses("bytes of a program", 60, "UTF-8", soundFile() + std::string("\0\1\2", 3)),
      refuses("empty file", 1, "begin with", ""),
  };
}

std::vector<RealFile> wrongHeads() {
  return {
      refuses("degrees for a linear axis", 7, "'Z_mm'", withName(2, "Z_deg")),
      refuses("column twice", 7, "twice", withName(3, "Z_mm")),
      refuses("readings in another unit", 7, "expected dev_um", withName(4, "dev_mm")),
      refuses("no version", 1, "import", withHead(0, "#laser report")),
      refuses("wrong axis", 4, "Z, C, X", withHead(3, "#axis: Y")),
      refuses("unknown instrument", 3, "laser-linear", withHead(2, "#instrument: laser")),
      refuses("point in two numbers", 5, "x y z", withHead(4, "#point_mm: 0 0")),
      refuses("unknown machine", 2, "built-in machine", withHead(1, "#machine: shop 7")),
  };
}

}  // namespace

std::string soundFile() { return Sheet().text(); }

std::vector<RealFile> realFiles() {
  std::vector<RealFile> all;
  for (const std::vector<RealFile>& group : {layouts(), missing(), mistakes(), wrongCells(), wrongHeads()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace nineline::measurement
