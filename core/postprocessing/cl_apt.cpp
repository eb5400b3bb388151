#include "core/postprocessing/cl_apt.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/postprocessing/cl_builder.h"
#include "core/postprocessing/cl_statement.h"
#include "core/postprocessing/cl_words.h"

namespace nineline::postprocessing {

namespace {

constexpr double kUnitLength = 1e-3;  // how far a tool axis may be from a unit vector, theory.md 4.2

class AptReader {
 public:
  AptReader(const ClOptions& options, ClProgram& program, Diagnostics& faults)
      : program_(program), faults_(faults), builder_(program, options) {}

  void read(const ClStatement& statement) {
    statement_ = &statement;
    if (readMotion() || readModal() || readFunction() || readTextual()) return;
    if (isSilentClWord(statement.word)) return;
    if (mayMoveTool(statement.word))
      return fault("post.cl-motion", unreadable("moves the tool or its frame"));
    program_.warnings.countedWarning(
        "post.cl-statement",
        fmt::format("The statement {} is not known; it becomes a comment.", statement.word), statement.line);
    comment(statement.word + (statement.text.empty() ? "" : "/" + statement.text));
  }

 private:
  bool is(std::string_view word) const { return statement_->word == word; }
  const std::vector<ClField>& fields() const { return statement_->fields; }

  void fault(const char* code, std::string text) {
    faults_.error(code, std::move(text), statement_->line, statement_->column);
  }
  void faultAt(const ClField& field, const char* code, std::string text) {
    faults_.error(code, std::move(text), field.line, field.column);
  }
  std::string unreadable(const char* why) const {
    return fmt::format("The statement {} {}, which is not read here; expected GOTO, GODLTA, CIRCLE or CYCLE.",
                       statement_->word, why);
  }
  void comment(std::string text) {
    builder_.addEvent({ClEvent::Kind::Comment, 0, 0.0, 0, std::move(text), statement_->line});
  }
  void event(ClEvent::Kind kind, double value = 0.0, int choice = 0) {
    builder_.addEvent({kind, 0, value, choice, {}, statement_->line});
  }

  std::optional<double> number(const ClField& field, const char* expected = "a number") {
    const std::optional<double> value = parseNumber(field.text);
    if (!value) {
      faultAt(field, "post.cl-number",
              fmt::format("{} needs {}, found '{}'.", statement_->word, expected, printable(field.text)));
    }
    return value;
  }
  /// All fields as numbers, `most` of them at most; nothing after a fault.
  std::optional<std::vector<double>> numbers(std::size_t least, std::size_t most, const char* expected) {
    std::vector<double> values;
    for (const ClField& field : fields()) {
      const std::optional<double> value = number(field);
      if (!value) return std::nullopt;
      values.push_back(*value);
    }
    if (values.size() >= least && values.size() <= most) return values;
    fault("post.cl-count",
          fmt::format("{} has {} numbers, expected {}.", statement_->word, values.size(), expected));
    return std::nullopt;
  }
  std::optional<Vector3d> unit(const std::vector<double>& values, std::size_t first) {
    const Vector3d v(values[first], values[first + 1], values[first + 2]);
    if (std::abs(v.norm() - 1.0) <= kUnitLength) return v.normalized();
    faultAt(fields()[first], "post.cl-axis",
            fmt::format("{} has a direction of length {:.6g}, expected a unit vector.", statement_->word,
                        v.norm()));
    return std::nullopt;
  }

  bool readMotion() {
    if (is("GOTO") || is("FROM") || is("GODLTA")) return readPoint(), true;
    if (is("CIRCLE")) return readCircle(), true;
    if (is("CYCLE")) return readCycle(), true;
    if (is("RAPID")) return builder_.rapid_next = true;
    if (!is("TLAXIS")) return false;
    if (const auto values = numbers(3, 3, "the three components of the tool axis")) {
      if (const auto axis = unit(*values, 0)) builder_.axis = *axis;
    }
    return true;
  }

  void readPoint() {
    const bool increment = is("GODLTA");
    if (increment && fields().size() == 1) return readAxialIncrement();
    const auto values = numbers(3, 6, "x, y, z or x, y, z, i, j, k");
    if (!values) return;
    if (values->size() != 3 && values->size() != 6) {
      return fault("post.cl-count", fmt::format("{} has {} numbers, expected x, y, z or x, y, z, i, j, k.",
                                                statement_->word, values->size()));
    }
    if (values->size() == 6) {
      const auto axis = unit(*values, 3);
      if (!axis) return;
      builder_.axis = *axis;
    }
    Vector3d tip = length_ * Vector3d((*values)[0], (*values)[1], (*values)[2]);
    if (increment && !builder_.place()) return needsPlace();
    if (increment) tip += *builder_.place();
    go(tip);
  }
  /// GODLTA with one number moves along the tool axis.
  void readAxialIncrement() {
    const auto distance = number(fields()[0]);
    if (!distance) return;
    if (!builder_.place()) return needsPlace();
    go(*builder_.place() + length_ * *distance * builder_.axis);
  }
  void needsPlace() {
    fault("post.cl-start", "GODLTA needs a place to start from; expected GOTO or FROM before.");
  }
  void go(const Vector3d& tip) {
    if (is("FROM")) {
      if (program_.points.empty()) return builder_.from(tip, statement_->line);
      return fault("post.cl-from",
                   "FROM states where the tool stands at the start, found it behind a motion.");
    }
    const std::string wrong = builder_.moveTo(tip, statement_->line);
    if (!wrong.empty()) fault("post.cl-arc", wrong);
  }

  void readCircle() {
    const auto values = numbers(7, 64, "the centre x, y, z, the normal i, j, k and the radius");
    if (!values) return;
    const auto normal = unit(*values, 3);
    if (!normal) return;
    if (!((*values)[6] > 0.0)) return faultAt(fields()[6], "post.cl-arc", "CIRCLE needs a radius above 0.");
    ClArc arc;
    arc.centre = length_ * Vector3d((*values)[0], (*values)[1], (*values)[2]);
    arc.normal = *normal;
    arc.radius = length_ * (*values)[6];
    arc.line = statement_->line;
    builder_.arc = arc;
  }

  void readCycle() {
    if (fields().empty()) return fault("post.cl-cycle", unreadable("without a kind"));
    const std::string kind = upper(fields()[0].text);
    if (kind == "OFF" || kind == "NOMORE") return builder_.cycle.reset();
    if (kind == "ON") {
      if (last_cycle_) builder_.cycle = last_cycle_;
      return last_cycle_ ? void() : fault("post.cl-cycle", "CYCLE/ON stands before any other CYCLE.");
    }
    if (kind != "DRILL" && kind != "FACE" && kind != "DEEP") {
      return faultAt(
          fields()[0], "post.cl-cycle",
          fmt::format("CYCLE/{} is not read here, expected DRILL, FACE, DEEP or OFF.", printable(kind)));
    }
    ClCycle cycle;
    for (std::size_t i = 1; i < fields().size(); i += 2) {
      if (!readCycleValue(i, cycle)) return;
    }
    if (!(cycle.depth > 0.0))
      return fault("post.cl-cycle", "CYCLE needs the depth: DEPTH,d or FEDTO,-d with d above 0.");
    last_cycle_ = builder_.cycle = cycle;
  }
  bool readCycleValue(std::size_t at, ClCycle& cycle) {
    const std::string key = upper(fields()[at].text);
    if (at + 1 == fields().size()) {
      faultAt(fields()[at], "post.cl-cycle",
              fmt::format("CYCLE needs a number behind '{}'.", printable(key)));
      return false;
    }
    const auto value = number(fields()[at + 1]);
    if (!value) return false;
    const double size = length_ * *value;
    if (key == "DEPTH") return cycle.depth = size, true;
    if (key == "FEDTO") return cycle.depth = -size, true;
    if (key == "CLEAR" || key == "RAPTO") return cycle.clearance = size, true;
    if (key == "RTRCTO" || key == "RETURN") return cycle.retract = size, true;
    if (key == "STEP") return cycle.step = size, true;
    if (key == "DWELL") return cycle.dwell = *value, true;
    if (setFeed(key, *value, cycle.feed, cycle.feed_kind)) return true;
    faultAt(
        fields()[at], "post.cl-cycle",
        fmt::format("CYCLE has the word '{}', expected DEPTH, FEDTO, CLEAR, RAPTO, RTRCTO, STEP, DWELL or a "
                    "feed unit.",
                    printable(key)));
    return false;
  }

  /// Sets a feed with its unit; false where the unit is not known.
  bool setFeed(std::string_view unit_name, double value, std::optional<double>& feed, ClFeed& kind) const {
    struct Unit {
      std::string_view name;
      bool per_turn;
      double length;
    };
    const std::array<Unit, 8> units = {
        Unit{"MMPM", false, 1.0},       Unit{"IPM", false, kMillimetresPerInch},
        Unit{"MMPR", true, 1.0},        Unit{"IPR", true, kMillimetresPerInch},
        Unit{"PERMIN", false, length_}, Unit{"PERREV", true, length_},
        Unit{"", false, length_},       Unit{"MMPMIN", false, 1.0}};
    for (const Unit& one : units) {
      if (one.name != unit_name) continue;
      kind = one.per_turn ? ClFeed::PerRevolution : ClFeed::PerMinute;
      feed = one.per_turn ? value * one.length : perSecondFromPerMinute(value * one.length);
      return true;
    }
    return false;
  }

  bool readModal() {
    if (is("FEDRAT")) return readFeed(), true;
    if (is("UNITS")) return readUnits(), true;
    return false;
  }
  void readFeed() {
    std::optional<double> value;
    std::string unit_name;
    for (const ClField& field : fields()) {
      const bool is_word =
          !field.text.empty() && std::isalpha(static_cast<unsigned char>(field.text[0])) != 0;
      if (is_word && unit_name.empty()) {
        unit_name = upper(field.text);
      } else {
        value = number(field, "a feed and at most one unit");
        if (!value) return;
      }
    }
    if (!value || !(*value > 0.0)) return fault("post.cl-feed", "FEDRAT needs a feed above 0.");
    if (setFeed(unit_name, *value, builder_.feed, builder_.feed_kind)) return;
    fault("post.cl-feed",
          fmt::format("FEDRAT has the unit '{}', expected MMPM, IPM, MMPR, IPR, PERMIN or PERREV.",
                      printable(unit_name)));
  }
  void readUnits() {
    const std::string unit_name = fields().size() == 1 ? upper(fields()[0].text) : "";
    if (unit_name == "MM") {
      length_ = 1.0;
    } else if (unit_name == "INCH" || unit_name == "INCHES") {
      length_ = kMillimetresPerInch;
    } else {
      fault("post.cl-units",
            fmt::format("UNITS has '{}', expected MM or INCHES.", printable(statement_->text)));
    }
  }

  bool readFunction() {
    using Kind = ClEvent::Kind;
    if (is("SPINDL")) return readSpindle(), true;
    if (is("COOLNT")) return readCoolant(), true;
    if (is("LOADTL")) return readWhole(Kind::ToolChange, "the number of a tool"), true;
    if (is("AUXFUN")) return readWhole(Kind::MachineCode, "the number of an M code"), true;
    if (is("STOP")) return event(Kind::Stop), true;
    if (is("OPSTOP")) return event(Kind::OptionalStop), true;
    if (!is("DELAY")) return false;
    if (const auto values = numbers(1, 1, "seconds")) event(Kind::Dwell, values->front());
    return true;
  }
  void readWhole(ClEvent::Kind kind, const char* expected) {
    const auto value = fields().empty() ? std::nullopt : parseInteger(fields()[0].text);
    const bool changes_flow = kind == ClEvent::Kind::MachineCode && value &&
                              (*value == 2 || *value == 30 || *value == 98 || *value == 99);
    if (value && *value >= 0 && *value < 100'000'000 && !changes_flow)
      return event(kind, static_cast<double>(*value));
    fault("post.cl-number",
          fmt::format("{} needs {}, found '{}'.", statement_->word, expected, printable(statement_->text)));
  }
  void readSpindle() {
    std::optional<double> speed;
    for (const ClField& field : fields()) {
      const std::string word = upper(field.text);
      if (word == "OFF") return event(ClEvent::Kind::SpindleOff);
      if (word == "CLW") {
        spindle_sense_ = 1;
      } else if (word == "CCLW") {
        spindle_sense_ = -1;
      } else if (word == "SFM" || word == "SMM") {
        return faultAt(field, "post.cl-spindle", "SPINDL states a surface speed, expected RPM.");
      } else if (word != "RPM" && word != "ON") {
        speed = number(field, "a speed, RPM, CLW, CCLW, ON or OFF");
        if (!speed) return;
      }
    }
    if (speed) spindle_speed_ = std::abs(*speed);
    if (speed && *speed < 0.0) spindle_sense_ = -spindle_sense_;
    if (!spindle_speed_)
      return fault("post.cl-spindle", "SPINDL turns the spindle on before any speed is stated.");
    event(ClEvent::Kind::SpindleOn, *spindle_speed_, spindle_sense_);
  }
  void readCoolant() {
    const std::string word = fields().empty() ? "ON" : upper(fields()[0].text);
    if (word == "OFF") return event(ClEvent::Kind::CoolantOff);
    if (word == "ON" || word == "FLOOD") return event(ClEvent::Kind::CoolantOn, 0.0, 0);
    if (word == "MIST") return event(ClEvent::Kind::CoolantOn, 0.0, 1);
    program_.warnings.countedWarning(
        "post.cl-coolant",
        fmt::format("COOLNT/{} has no code of its own; it becomes a comment.", printable(word)),
        statement_->line);
    comment("COOLNT/" + word);
  }

  bool readTextual() {
    if (is("PARTNO") && program_.name.empty()) {
      program_.name = statement_->text;
      return true;
    }
    if (!is("PPRINT") && !is("PARTNO") && !is("REMARK")) return false;
    if (!statement_->text.empty()) comment(statement_->text);
    return true;
  }

  ClProgram& program_;
  Diagnostics& faults_;
  ClBuilder builder_;
  const ClStatement* statement_ = nullptr;
  double length_ = 1.0;  // mm for one unit
  std::optional<ClCycle> last_cycle_;
  std::optional<double> spindle_speed_;
  int spindle_sense_ = 1;
};

}  // namespace

void readApt(std::string_view text, const ClOptions& options, ClProgram& program, Diagnostics& faults) {
  AptReader reader(options, program, faults);
  ClStatementReader statements(text);
  ClStatement statement;
  while (!faults.full() && statements.next(statement)) reader.read(statement);
}

}  // namespace nineline::postprocessing
