#include "tests/campaign/real_programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include "core/base/contract.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/compensation/compensation.h"
#include "core/kinematics/machine_file.h"
#include "tests/campaign/rs274_reader.h"
#include "tests/campaign/second_opinion.h"
#include "tests/core/nc/canonical_calls.h"
#include "tests/support/random_machines.h"

namespace nineline::campaign {

namespace fs = std::filesystem;
using kinematics::Machine;

namespace {

/// Turning programs, whose X words are diameters. LinuxCNC's are radii, unless G7 says otherwise.
const std::set<std::string> kLathes = {"FANUC0T.nc", "0100.nc", "TOKARKA.NC", "OSP7000L.nc"};

/// Built-in structures in the order in which they are tried.
constexpr std::array<const char*, 5> kStructures = {"generic-3axis", "b2-k3032", "trunnion-ac",
                                                    "table-head-bc", "propeller-c2zxc1b1"};

/// FNV-1a: the same seed for the same name on every machine.
unsigned seedOf(const std::string& name) {
  unsigned hash = 2166136261U;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

struct Reading {
  std::size_t blocks = 0;
  std::size_t motions = 0;
  std::set<char> axes;
  nc::Dialect dialect = nc::Dialect::Fanuc;
  std::optional<Error> error;
};

Reading readProgram(const std::string& name, const std::string& text, nc::InterpreterOptions options) {
  Reading reading;
  nc::MemoryText source(name, text);
  nc::Interpreter interpreter(source, options);
  for (;;) {
    const Result<const nc::ExecutedBlock*> block = interpreter.next();
    if (!block) reading.error = block.error();
    if (!block || *block == nullptr) break;
    ++reading.blocks;
    for (const nc::Motion& motion : (*block)->motions) {
      ++reading.motions;
      for (int i = 0; i < options.axes.count; ++i) {
        if (nc::contains(motion.commanded, i))
          reading.axes.insert(options.axes.axes[static_cast<std::size_t>(i)].id.letter);
      }
    }
  }
  if (!reading.error && interpreter.diagnostics().hasErrors())
    reading.error = interpreter.diagnostics().firstError(name);
  reading.dialect = interpreter.dialect();
  return reading;
}

/// A built-in machine without limits of travel: the programs were written for others.
Machine machineOf(const std::string& id, bool lathe) {
  Machine::Description description = kinematics::findBuiltInMachine(id)->description();
  for (auto* chain : {&description.workpiece_chain, &description.tool_chain}) {
    for (kinematics::Joint& joint : *chain) {
      joint.travel.reset();
      joint.diameter = lathe && joint.axis.letter == 'X';
    }
  }
  return Machine::make(std::move(description)).value();
}

std::optional<Machine> structureFor(const std::set<char>& axes, bool lathe) {
  for (const char* const id : kStructures) {
    const Machine machine = machineOf(id, lathe);
    if (lathe && machine.find({'Y', 0}) >= 0) continue;
    const bool fits = std::all_of(axes.begin(), axes.end(), [&](char axis) {
      return machine.find({axis, 0}) >= 0;
    });
    if (fits) return machine;
  }
  return std::nullopt;
}

std::string nameOf(nc::Dialect dialect) {
  switch (dialect) {
    case nc::Dialect::Siemens:
      return "Siemens";
    case nc::Dialect::LinuxCnc:
      return "LinuxCNC";
    default:
      return "Fanuc";
  }
}

std::string refusal(const Error& error) {
  return withoutBars(fmt::format("refused, line {}: {}", error.line, error.text));
}

/// Lengths of the tools of a LinuxCNC tool table, mm; `unit`: of the table.
std::map<int, double> toolLengthsOf(const std::string& table, double unit) {
  std::map<int, double> lengths;
  const std::string text = upper(table);
  for (const std::string_view line : split(text, '\n')) {
    const std::size_t tool = line.find('T');
    const std::size_t z = line.find('Z');
    if (tool == std::string_view::npos || z == std::string_view::npos) continue;
    lengths[std::atoi(std::string(line.substr(tool + 1)).c_str())] =
        unit * std::atof(std::string(line.substr(z + 1)).c_str());
  }
  return lengths;
}

/// Calls by which a rigid tap states where it stands count as motions.
std::string withTapsAsFeeds(std::string calls) {
  constexpr std::string_view kTap = "RIGID_TAP(";
  for (std::size_t at = calls.find(kTap); at != std::string::npos; at = calls.find(kTap, at))
    calls.replace(at, kTap.size(), "STRAIGHT_FEED(");
  return calls;
}

/// In inverse time the control finds the feed from the length of each block, which the correction changes.
std::string withoutFeeds(const std::string& calls) {
  std::string text;
  for (const std::string_view line : split(calls, '\n')) {
    if (line.find("SET_FEED_RATE(") == std::string_view::npos) text += std::string(line) + "\n";
  }
  return text;
}

/// Without the codes that switch tool-centre-point control, which stand-alone `rs274` lacks. The linear words
/// are the tip then, here and there.
std::string withoutKinematicSwitches(std::string text) {
  for (const std::string_view code : {"M428", "M429", "M430"}) {
    for (std::size_t at = text.find(code); at != std::string::npos; at = text.find(code, at))
      text.replace(at, code.size(), "    ");
  }
  return text;
}

/// Whether rs274 reads the corrected program as we do, and nothing but motions has changed in it.
std::string secondOpinion(const fs::path& scratch, const fs::path& file, const std::string& original,
                          const std::string& corrected, const nc::InterpreterOptions& options) {
  if (!SecondOpinion::isInstalled()) return "not installed";
  const std::string tools = toolTableBeside(file);
  const Rs274 before = runRs274(scratch, withoutKinematicSwitches(original), tools);
  if (!before.fault.empty()) return withoutBars("does not read the original: " + before.fault);
  const std::string beforehand = motionDifference(original, before, options);
  if (!beforehand.empty()) return withoutBars("reads the original otherwise: " + beforehand);
  const Rs274 after = runRs274(scratch, withoutKinematicSwitches(corrected), tools);
  if (!after.fault.empty()) return withoutBars("DOES NOT READ THE CORRECTED: " + after.fault);
  const std::string difference = motionDifference(corrected, after, options);
  if (!difference.empty()) return withoutBars("OTHER MOTION: " + difference);
  const std::string changed = changedMeaning(withTapsAsFeeds(before.calls), withTapsAsFeeds(after.calls));
  const bool inverse_time = original.find("G93") != std::string::npos;
  if (!changed.empty() && inverse_time &&
      changedMeaning(withoutFeeds(before.calls), withoutFeeds(after.calls)).empty())
    return "same motions, same meaning; inverse-time feeds follow the corrected lengths";
  if (!changed.empty()) return withoutBars("same motions; OTHER MEANING: " + changed);
  return "same motions, same meaning";
}

std::string warningsOf(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& one : diagnostics.all()) {
    if (text.size() > 200) return text + " …";
    text += (text.empty() ? "" : " ") + one.text;
  }
  return withoutBars(text);
}

void compensate(RealProgram& row, const Machine& machine, const std::string& text,
                const simulation::ProgramSetup& setup, const fs::path& file, const fs::path& scratch) {
  test_support::Random random(seedOf(row.file));
  const errors::ErrorModel model = test_support::randomModel(random, machine);
  compensation::CompensationOptions options;
  options.linear_decimals = 4;
  options.rotary_decimals = 4;
  NoProgress progress;
  const Result<compensation::CompensatedText> done =
      compensation::compensateText(model, row.file, text, setup, options, progress);
  if (!done) {
    row.remark = refusal(done.error());
    return;
  }
  row.compensated = true;
  row.rms_before_um = umFromMm(done->report.before.norm.rms);
  row.rms_after_um = umFromMm(done->report.after.norm.rms);
  row.remark = warningsOf(done->report.diagnostics);
  row.second_opinion =
      row.dialect != "LinuxCNC"
          ? "another dialect"
          : secondOpinion(scratch, file, text, done->text, simulation::interpreterOptionsOf(machine, setup));
}

RealProgram runOne(const fs::path& data, const fs::path& file, const fs::path& scratch) {
  RealProgram row;
  row.file = fs::relative(file, data).generic_string();
  const std::string name = file.filename().string();
  const std::string text = readFile(file).value();
  const bool lathe = kLathes.contains(name);
  const bool linuxcnc = row.file.starts_with("nc-linuxcnc");
  const bool metric_table = !name.starts_with("g76only");
  simulation::ProgramSetup setup;
  if (linuxcnc) setup.dialect = nc::Dialect::LinuxCnc;
  setup.tool_lengths = toolLengthsOf(toolTableBeside(file), metric_table ? 1.0 : kMillimetresPerInch);
  nc::InterpreterOptions options;
  options.dialect = setup.dialect;
  options.axes = nc::testing::sixAxes();
  if (lathe) options.axes = simulation::axisLayoutOf(machineOf("b2-k3032", true));
  options.tool_lengths = setup.tool_lengths;
  const Reading reading = readProgram(row.file, text, options);
  row.dialect = nameOf(reading.dialect);
  row.blocks = reading.blocks;
  row.motions = reading.motions;
  if (reading.error) {
    row.remark = refusal(*reading.error);
    return row;
  }
  const std::optional<Machine> machine = structureFor(reading.axes, lathe);
  if (!machine) {
    row.remark = "no built-in structure has the axes ";
    for (const char axis : reading.axes) row.remark += axis;
    return row;
  }
  row.structure = machine->id();
  if (row.motions == 0) {
    row.remark = "moves nothing";
    return row;
  }
  compensate(row, *machine, text, setup, file, scratch);
  return row;
}

bool isProgram(const fs::path& file) {
  static const std::set<std::string> kKinds = {".nc", ".NC", ".mpf", ".ngc"};
  return kKinds.contains(file.extension().string()) || file.filename().string().ends_with(".mpf.txt");
}

}  // namespace

std::vector<RealProgram> runRealPrograms(const fs::path& data, const fs::path& scratch) {
  fs::create_directories(scratch);
  std::vector<fs::path> files;
  for (const fs::directory_entry& folder : fs::directory_iterator(data)) {
    if (!folder.path().filename().string().starts_with("nc-")) continue;
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder)) {
      if (file.is_regular_file() && isProgram(file.path())) files.push_back(file.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<RealProgram> rows;
  for (const fs::path& file : files) {
    try {
      rows.push_back(runOne(data, file, scratch));
    } catch (const ContractViolation& fault) {  // a fault of ours: it must show in the table, not end it
      RealProgram row;
      row.file = fs::relative(file, data).generic_string();
      row.remark = withoutBars(std::string("FAULT: ") + fault.what());
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace nineline::campaign
