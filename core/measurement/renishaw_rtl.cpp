#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/measurement/delimited_text.h"
#include "core/measurement/import.h"
#include "core/measurement/rtl_text.h"

namespace nineline::measurement {

namespace {

/// Sum over the targets of the scatter of the readings within each direction; small where the pairing is
/// right.
double scatterOf(const RtlText& text, const std::map<long long, int>& senses) {
  std::map<std::pair<long long, int>, std::vector<double>> groups;
  for (const DeviationRow& row : text.rows) groups[{row.target, senses.at(row.run)}].push_back(row.deviation);
  double squares = 0.0;
  for (const auto& [key, values] : groups) {
    double mean = 0.0;
    for (const double value : values) mean += value / static_cast<double>(values.size());
    for (const double value : values) squares += (value - mean) * (value - mean);
  }
  return squares;
}

std::map<long long, int> sensesOf(const RtlText& text, const std::string& pairing) {
  std::set<long long> runs;
  for (const DeviationRow& row : text.rows) runs.insert(row.run);
  std::map<long long, int> senses;
  std::size_t n = 0;
  for (const long long run : runs) {
    const bool backward = pairing == "alternate" ? n % 2 == 1
                          : pairing == "halves"  ? 2 * n >= runs.size()
                                                 : pairing == "backward";
    senses[run] = backward ? -1 : 1;
    ++n;
  }
  return senses;
}

Question directionQuestion(const RtlText& text) {
  Question question{"direction",
                    "Which runs were measured in the negative direction? The file does not say it.",
                    {{"alternate", "every second run (2, 4, …)"},
                     {"halves", "the second half of the runs"},
                     {"forward", "none, all runs go in the positive direction"},
                     {"backward", "all of them"}},
                    "",
                    std::nullopt};
  const double alternate = scatterOf(text, sensesOf(text, "alternate"));
  const double halves = scatterOf(text, sensesOf(text, "halves"));
  const double together = scatterOf(text, sensesOf(text, "forward"));
  if (alternate < 0.5 * std::min(halves, together)) question.likeliest = "alternate";
  if (halves < 0.5 * std::min(alternate, together)) question.likeliest = "halves";
  return question;
}

/// Everything that the file leaves open, answered.
struct Conventions {
  int joint = -1;
  InstrumentKind kind = InstrumentKind::LaserLinear;
  double scale = 1.0;  // file unit → mm or rad
  std::map<long long, int> senses;
  Instrument instrument;
};

std::optional<int> askAxis(const RtlText& text, const Machine& machine, const Answers& answers,
                           Import& import) {
  const std::optional<AxisId> named = parseAxisId(trimmed(text.axis));
  if (named && machine.find(*named) >= 0 && !answers.contains("axis")) return machine.find(*named);
  Question question{"axis",
                    fmt::format("Which axis was measured? The file says '{}'.", printable(text.axis)),
                    {},
                    "",
                    std::nullopt};
  for (const kinematics::Joint& joint : machine.joints()) {
    question.choices.push_back({joint.axis.text(), joint.axis.text()});
  }
  const std::optional<std::string> answer = answerTo(std::move(question), answers, import);
  if (!answer) return std::nullopt;
  return machine.find(*parseAxisId(*answer));
}

std::optional<InstrumentKind> askKind(const RtlText& text, const Answers& answers, Import& import) {
  for (const auto& [word, kind] : {std::pair{"ANGULAR", InstrumentKind::LaserAngular},
                                   {"STRAIGHT", InstrumentKind::LaserStraightness},
                                   {"LINEAR", InstrumentKind::LaserLinear}}) {
    if (text.kind_text.find(word) != std::string::npos && !answers.contains("kind")) return kind;
  }
  const std::optional<std::string> answer = answerTo({"kind",
                                                      "What did the laser measure? The file does not say it.",
                                                      {{"laser-linear", "positioning along the axis"},
                                                       {"laser-angular", "an angle"},
                                                       {"laser-straightness", "straightness"}},
                                                      "",
                                                      std::nullopt},
                                                     answers, import);
  return answer ? parseInstrumentKind(*answer) : std::nullopt;
}

std::optional<double> askAngularUnit(const Answers& answers, Import& import) {
  const std::optional<std::string> answer =
      answerTo({"angle-unit",
                "In which unit are the angular deviations? Readers of this format disagree.",
                {{"mrad", "mrad (mm/m)"}, {"urad", "µrad (µm/m)"}, {"arcsec", "arc seconds"}},
                "",
                std::nullopt},
               answers, import);
  if (!answer) return std::nullopt;
  return *answer == "mrad" ? 1e-3 : *answer == "urad" ? 1e-6 : radFromArcsec(1.0);
}

std::optional<int> askBedAxis(const std::string& id, const std::string& text, const Answers& answers,
                              Import& import) {
  const std::optional<std::string> answer =
      answerTo({id, text, {{"X", "X"}, {"Y", "Y"}, {"Z", "Z"}}, "", std::nullopt}, answers, import);
  return answer ? std::optional((*answer)[0] - 'X') : std::nullopt;
}

void askPoint(const Answers& answers, Import& import, Instrument& instrument) {
  const std::optional<std::string> answer =
      answerTo({"point",
                "Where does the beam meet the moving body, in the workpiece frame with all axes at zero?",
                {},
                "three numbers x y z in mm",
                std::nullopt},
               answers, import);
  if (!answer) return;
  std::vector<double> numbers;
  for (const std::string_view word : wordsOf(*answer)) {
    if (const std::optional<double> number = parseNumber(word)) numbers.push_back(*number);
  }
  if (numbers.size() == 3) {
    instrument.point = {numbers[0], numbers[1], numbers[2]};
  } else {
    import.diagnostics.error(
        "import.answer",
        fmt::format("'{}' is no point, expected three numbers x y z in mm.", printable(*answer)));
  }
}

/// Asks all that is open at once, so that a dialog shows it together.
Conventions ask(const RtlText& text, const Machine& machine, const Answers& answers, Import& import) {
  Conventions conventions;
  conventions.joint = askAxis(text, machine, answers, import).value_or(-1);
  const std::optional<InstrumentKind> kind = askKind(text, answers, import);
  conventions.kind = kind.value_or(InstrumentKind::LaserLinear);
  conventions.instrument.kind = conventions.kind;
  if (kind == InstrumentKind::LaserAngular) {
    conventions.scale = askAngularUnit(answers, import).value_or(1.0);
    conventions.instrument.about =
        askBedAxis("about", "About which axis of the bed was the angle measured?", answers, import)
            .value_or(0);
  } else {
    conventions.scale = mmFromUm(1.0);
    askPoint(answers, import, conventions.instrument);
  }
  if (kind == InstrumentKind::LaserStraightness) {
    conventions.instrument.sensitive =
        askBedAxis("sensitive", "Along which axis of the bed was the straightness measured?", answers, import)
            .value_or(0);
  }
  std::set<long long> runs;
  for (const DeviationRow& row : text.rows) runs.insert(row.run);
  std::optional<std::string> pairing = "forward";
  if (runs.size() > 1) pairing = answerTo(directionQuestion(text), answers, import);
  conventions.senses = sensesOf(text, pairing.value_or("forward"));
  return conventions;
}

Measurement measurementFrom(const RtlText& text, const Conventions& conventions, const Machine& machine,
                            const std::string& source) {
  Measurement out;
  out.source = source;
  out.machine_id = machine.id();
  out.instrument = conventions.instrument;
  out.instrument.axis = machine.joint(conventions.joint).axis;
  const bool angular = conventions.kind == InstrumentKind::LaserAngular;
  out.channels = {{angular ? Quantity::Angle : Quantity::Length}};
  const auto joint = static_cast<std::size_t>(conventions.joint);
  out.commanded.assign(static_cast<std::size_t>(machine.jointCount()), false);
  out.commanded[joint] = true;
  std::vector<DeviationRow> rows = text.rows;  // in the order in which they were taken
  std::stable_sort(rows.begin(), rows.end(), [&](const DeviationRow& one, const DeviationRow& other) {
    if (one.run != other.run) return one.run < other.run;
    const double difference = text.targets[static_cast<std::size_t>(one.target - 1)] -
                              text.targets[static_cast<std::size_t>(other.target - 1)];
    return conventions.senses.at(one.run) > 0 ? difference < 0.0 : difference > 0.0;
  });
  Covariate run{"run", {}};
  Covariate approach{"approach_" + out.instrument.axis->text() + "_1", {}};
  for (const DeviationRow& row : rows) {
    Sample sample;
    const double target = text.targets[static_cast<std::size_t>(row.target - 1)];
    sample.q[joint] = machine.isRotary(conventions.joint) ? radFromDeg(target) : target;
    sample.line = row.line;
    out.samples.push_back(sample);
    out.readings.emplace_back(row.deviation * conventions.scale);
    run.values.emplace_back(static_cast<double>(row.run));
    approach.values.emplace_back(conventions.senses.at(row.run));
  }
  out.covariates = {std::move(run), std::move(approach)};
  return out;
}

}  // namespace

Import importRtl(std::string_view bytes, const std::string& source, const Machine& machine,
                 const Answers& answers) {
  Import import;
  import.format = "renishaw-rtl";
  const Result<DecodedText> decoded = decodeText(bytes, source);
  if (!decoded) {
    import.diagnostics.error(decoded.error().code, decoded.error().text, decoded.error().line);
    return import;
  }
  const RtlText text = readRtlText(decoded->text, import);
  if (import.diagnostics.hasErrors()) return import;
  const Conventions conventions = ask(text, machine, answers, import);
  if (import.isComplete()) import.measurements.push_back(measurementFrom(text, conventions, machine, source));
  return import;
}

}  // namespace nineline::measurement
