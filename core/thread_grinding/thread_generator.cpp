#include "core/thread_grinding/thread_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/thread_grinding/program_text.h"
#include "core/thread_grinding/thread_checks.h"

namespace nineline::thread_grinding {
namespace {

constexpr double kLargestWord = 999999.0;  // what controls store: six digits before the point

const char* nameOf(PassKind kind) {
  switch (kind) {
    case PassKind::Roughing:
      return "ROUGH";
    case PassKind::Finishing:
      return "FINISH";
    case PassKind::SparkOut:
      break;
  }
  return "SPARK-OUT";
}

/// Writes the whole program, pass by pass.
class Generator {
 public:
  Generator(const ThreadParameters& parameters, const MachineLimits& limits, const ThreadPlan& plan)
      : p_(parameters), plan_(plan), text_(parameters, limits), retract_x_(retractX(parameters, plan)) {}

  void writeAll() {
    writeHead();
    approach();
    for (std::size_t pass = 0; pass < plan_.passes.size(); ++pass) {
      if (p_.dress_every_passes > 0 && pass > 0 &&
          pass % static_cast<std::size_t>(p_.dress_every_passes) == 0)
        dress();
      for (const int start : plan_.start_indices) grind(pass, start);
    }
    leave();
  }
  ProgramText& text() { return text_; }

 private:
  void writeHead();
  void approach();
  void dress();
  void grind(std::size_t pass, int start);
  void leave();
  [[nodiscard]] double safeX() const { return retract_x_ + plan_.inward * p_.safety; }
  /// z clear of the bore, on the side from which passes begin.
  [[nodiscard]] double outsideZ() const {
    const double outward = p_.towards_plus ? -1.0 : 1.0;
    return p_.start_z - (plan_.first_wz + outward * p_.safety);
  }
  /// Turns to add to a path so that its first angle is reached without turning back.
  [[nodiscard]] double turnsOn(double first, double last) const;

  const ThreadParameters& p_;
  const ThreadPlan& plan_;
  ProgramText text_;
  double retract_x_;
  bool placed_ = false;
};

void Generator::writeHead() {
  const ThreadGeometry& thread = plan_.geometry;
  text_.line("%");
  text_.line(fmt::format("O{:04d}", p_.program_number));
  if (!p_.name.empty()) text_.comment(p_.name);
  text_.comment(fmt::format("{} THREAD {:g} X {:g}, LENGTH {:g}, {} START{}, {} HAND",
                            p_.type == ThreadType::External ? "EXTERNAL" : "INTERNAL", p_.diameter, p_.pitch,
                            p_.length, p_.starts, p_.starts == 1 ? "" : "S",
                            p_.hand == Hand::Right ? "RIGHT" : "LEFT"));
  text_.comment(fmt::format("LEAD {:g}, PITCH DIAMETER {:.4f}, DEPTH {:.4f}, PASSES {}", thread.lead,
                            thread.pitch_diameter, plan_.depth, plan_.passes.size()));
  if (p_.taper != 0.0) text_.comment(fmt::format("TAPER {:g} OF RADIUS PER MM", p_.taper));
  text_.comment(fmt::format("WHEEL DIAMETER {:g}, RIBS {}, SWIVEL {:.4f} DEG", plan_.wheel_diameter,
                            p_.wheel_ribs, degFromRad(plan_.wheel_tilt)));
  text_.comment(fmt::format("X ZERO IS THE WORK AXIS, {}, C IS ABSOLUTE OVER MANY TURNS, ROLL-OVER OFF",
                            p_.axes.x_factor == 2.0 ? "WORDS ARE DIAMETERS" : "WORDS ARE RADII"));
  text_.comment(p_.feed_words == FeedWords::InverseTime
                    ? "F WITH G93: BLOCKS PER MINUTE"
                    : "F WITH G94: MM AND DEG OF C ADDED AS VECTOR, PER MINUTE");
  text_.line("G21 G90 G40 G80 G94");
  text_.code(p_.codes.work_offset);
  text_.code(p_.codes.wheel_on);
  text_.code(p_.codes.coolant_on);
  text_.comment("WORK SPINDLE AS C AXIS, REFERENCED");
  text_.code(p_.codes.c_axis_on);
}

void Generator::approach() {
  text_.comment("APPROACH");
  if (p_.type == ThreadType::External) {
    text_.rapidX(safeX());
  } else {
    text_.rapidZ(outsideZ());
  }
}

void Generator::dress() {
  text_.comment("DRESS THE WHEEL, THEN CORRECT THE X OFFSET BY THE RADIUS IT LOST");
  if (p_.type == ThreadType::External) text_.rapidX(safeX());
  if (p_.type == ThreadType::Internal) text_.rapidZ(outsideZ());
  text_.code(p_.codes.dress);
}

double Generator::turnsOn(double first, double last) const {
  if (p_.return_mode == ReturnMode::Unwind || !placed_) return 0.0;
  const double sense = last > first ? 1.0 : -1.0;
  return sense * kTurn * std::ceil(sense * (text_.gamma() - first) / kTurn - 1e-9);
}

void Generator::grind(std::size_t pass, int start) {
  const ThreadPass& cut = plan_.passes[pass];
  const double side = p_.infeed_mode == InfeedMode::Alternating && pass % 2 == 1 ? -1.0 : 1.0;
  const ThreadPath path = passPath(p_, plan_, cut.depth, start, side);
  const ThreadPoint first = pointAt(path, plan_.first_wz);
  const double turns = turnsOn(first.gamma, pointAt(path, plan_.last_wz).gamma);
  text_.comment(fmt::format("PASS {} OF {}, START {} OF {}, {}, DEPTH {:.4f}", pass + 1, plan_.passes.size(),
                            start + 1, p_.starts, nameOf(cut.kind), cut.depth));
  text_.rapidZC(first.z, first.gamma + turns);
  text_.rapidX(retract_x_);
  text_.feedX(first.x, p_.infeed_speed);
  placed_ = true;

  const double blocks = blocksPerPass(p_, plan_);
  const double pass_time = std::abs(plan_.last_wz - plan_.first_wz) / path.lead * kTurn / cut.speed;
  text_.beginSynchronous();
  for (double block = 1.0; block <= blocks; block += 1.0) {
    ThreadPoint point = pointAt(path, std::lerp(plan_.first_wz, plan_.last_wz, block / blocks));
    point.gamma += turns;
    text_.synchronous(point, pass_time / blocks);
  }
  text_.rapidX(retract_x_);
}

void Generator::leave() {
  text_.comment("END");
  if (p_.type == ThreadType::External) text_.rapidX(safeX());
  if (p_.type == ThreadType::Internal) text_.rapidZ(outsideZ());
  text_.code(p_.codes.c_axis_off);
  text_.code(p_.codes.coolant_off);
  text_.code(p_.codes.wheel_off);
  text_.line("M30");
  text_.line("%");
}

ThreadReport reportOf(const ThreadParameters& p, const ThreadPlan& plan, const ProgramText& text) {
  ThreadReport report;
  report.passes = plan.passes.size();
  report.cutting_passes = report.passes - static_cast<std::size_t>(p.spark_out_passes);
  report.starts = plan.start_indices.size();
  report.motion_blocks = text.motionBlocks();
  report.duration = text.duration();
  report.depth = plan.depth;
  report.final_radius = radiusAtDepth(plan, plan.depth);
  report.lead_in = plan.lead_in;
  report.run_out = plan.run_out;
  report.wheel_tilt = plan.wheel_tilt;
  report.geometry = plan.geometry;
  return report;
}

}  // namespace

Result<ThreadProgram> generateThread(const ThreadParameters& parameters, const MachineLimits& limits) {
  const Diagnostics findings = checkThread(parameters, limits);
  if (findings.hasErrors()) {
    Error error = findings.firstError("thread parameters");
    if (error.code == "thread.travel") error.kind = ErrorKind::NoAnswer;
    return error;
  }
  const ThreadPlan plan = derive(parameters, limits);
  Generator generator(parameters, limits, plan);
  generator.writeAll();
  if (generator.text().largestWord() > kLargestWord) {
    return noAnswer("thread.word_range",
                    fmt::format("A word of {:.3f} is larger than the {:g} that controls store; let C unwind "
                                "(return_mode) or move the zeros.",
                                generator.text().largestWord(), kLargestWord));
  }
  ThreadProgram program;
  program.report = reportOf(parameters, plan, generator.text());
  program.report.warnings = findings.all();
  program.text = generator.text().take();
  program.passes = plan.passes;
  const Result<CutThread> cut =
      checkHand(program.text, parameters, plan, limits.axes.value_or(parameters.axes));
  if (!cut) return cut.error();
  program.report.cut = *cut;
  return program;
}

Json reportJson(const ThreadReport& report) {
  Json warnings = Json::array();
  for (const Diagnostic& warning : report.warnings) warnings.push(warning.text);
  Json json = Json::object();
  json.set("passes", report.passes);
  json.set("cutting_passes", report.cutting_passes);
  json.set("starts", report.starts);
  json.set("blocks", report.motion_blocks);
  json.set("time_s", report.duration);
  json.set("depth_mm", report.depth);
  json.set("final_radius_mm", report.final_radius);
  json.set("pitch_diameter_mm", report.geometry.pitch_diameter);
  json.set("helix_angle_deg", degFromRad(report.geometry.helix_angle));
  json.set("wheel_tilt_deg", degFromRad(report.wheel_tilt));
  json.set("lead_in_mm", report.lead_in);
  json.set("run_out_mm", report.run_out);
  Json cut = Json::object();
  cut.set("hand", report.cut.hand == Hand::Right ? "right" : "left");
  cut.set("lead_mm", report.cut.lead);
  cut.set("starts", report.cut.starts);
  cut.set("depth_mm", report.cut.depth);
  json.set("virtual_thread", std::move(cut));
  json.set("warnings", std::move(warnings));
  return json;
}

}  // namespace nineline::thread_grinding
