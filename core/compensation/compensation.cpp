#include "core/compensation/compensation.h"

#include <fmt/format.h>

#include <array>
#include <chrono>

#include "core/base/file.h"
#include "core/base/units.h"
#include "core/compensation/program_corrector.h"
#include "core/compensation/verification.h"
#include "core/errors/effect_spec.h"

namespace nineline::compensation {

namespace {

/// mm: the deviation of a perfect machine that rounding may add.
constexpr double kWorse = 2e-3;

Result<void> checkOptions(const ErrorModel& model, const CompensationOptions& options) {
  if (!(options.tolerance > 0.0) || !(options.angle_tolerance > 0.0)) {
    return usageError("compensation.tolerance", "The tolerances must be above 0.");
  }
  if (!(options.largest_correction > 0.0) || !(options.largest_angle_correction > 0.0)) {
    return usageError("compensation.limit", "The limits of the correction must be above 0.");
  }
  for (const std::optional<int>& decimals : {options.linear_decimals, options.rotary_decimals}) {
    if (decimals && (*decimals < 0 || *decimals > 9))
      return usageError("compensation.decimals", "Words can have 0 to 9 decimals.");
  }
  if (options.mode == Mode::Thread && !hasWorkSpindle(model.machine())) {
    return usageError("compensation.mode",
                      "The thread mode needs a machine whose workpiece turns on a rotary axis.");
  }
  return {};
}

/// The last gate: a corrected program may not leave the ideal path further than the errors and a correction.
Result<void> checkOutcome(const CompensationReport& report, const CompensationOptions& options,
                          const std::string& name, std::size_t worst_line) {
  const double largest = report.before.norm.max + options.largest_correction;
  if (report.after.norm.max <= largest) return {};
  return noAnswer(
      "compensation.check",
      fmt::format("The check of the corrected program failed: it leaves the ideal path by {:.6g} mm. "
                  "Nothing was written.",
                  report.after.norm.max),
      name, worst_line);
}

/// Says in which directions a deviation remains that no joint can remove.
void warnRemains(CompensationReport& report, const CompensationOptions& options) {
  constexpr double kMostLeft = 0.5;  // of the deviation before
  const auto remains = [](const simulation::Figures& before, const simulation::Figures& after, double least) {
    return after.rms > least && after.rms > kMostLeft * before.rms;
  };
  const std::array<const simulation::Figures*, 3> before = {&report.before.x, &report.before.y,
                                                            &report.before.z};
  const std::array<const simulation::Figures*, 3> after = {&report.after.x, &report.after.y, &report.after.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!remains(*before[k], *after[k], 0.5 * options.tolerance)) continue;
    report.diagnostics.warning(
        "compensation.remains",
        fmt::format("A deviation of {:.3f} um (RMS) remains along {}: no axis that may move corrects it.",
                    umFromMm(after[k]->rms), "xyz"[k]));
  }
  if (remains(report.before.axis_tilt, report.after.axis_tilt, 0.5 * options.angle_tolerance)) {
    report.diagnostics.warning(
        "compensation.remains",
        fmt::format("The tool axis stays tilted by {:.2f} arcsec (RMS): no axis that may "
                    "move corrects it.",
                    arcsecFromRad(report.after.axis_tilt.rms)));
  }
}

/// Effects that the check counts and the correction leaves alone.
bool isLeftAlone(const errors::Effect& effect) {
  const errors::EffectSpec* spec = errors::findEffectSpec(effect.id());
  return spec != nullptr && !spec->isCorrectable();
}

void warnLeftAlone(const ErrorModel& model, CompensationReport& report) {
  for (const errors::EffectPtr& effect : model.effects()) {
    if (!isLeftAlone(*effect)) continue;
    report.diagnostics.warning(
        "compensation.left_alone",
        fmt::format(
            "The effect '{}' of {} follows the speed, the time or a reversal; no change of the program "
            "removes it.",
            effect->id(), effect->component().text()));
  }
}

}  // namespace

Result<CompensationReport> compensateProgram(
    const ErrorModel& whole, nc::TextSource& program, const ProgramSetup& setup,
    const CompensationOptions& options, const TextSink& sink,
    const std::function<Result<std::unique_ptr<nc::TextSource>>()>& corrected_text, Progress& progress,
    const ComparisonSink& compared) {
  const ErrorModel model = whole.onlyActive();
  const ErrorModel correctable = model.without(&isLeftAlone);
  if (Result<void> fine = checkOptions(model, options); !fine) return fine.error();
  if (Result<void> known = simulation::requireConditions(model, setup); !known) return known.error();
  const auto begin = std::chrono::steady_clock::now();
  ProgramCorrector corrector(correctable, setup, options, program, sink);
  if (Result<void> done = corrector.run(progress); !done) return done.error();
  CompensationReport report = corrector.takeReport();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  const Result<std::unique_ptr<nc::TextSource>> corrected = corrected_text();
  if (!corrected) return corrected.error();
  Result<Verification> check =
      verifyCorrection(model, setup, program, **corrected, corrector.log(), progress, compared);
  if (!check) {
    Error error = check.error();
    error.source = program.name();
    return error;
  }
  if (check->after.norm.rms > check->before.norm.rms + kWorse) {
    return noAnswer("compensation.worse",
                    fmt::format("The corrected program would be worse than the original: {:.6f} mm RMS "
                                "instead of {:.6f} mm. Nothing was written.",
                                check->after.norm.rms, check->before.norm.rms),
                    program.name(), check->worst_line);
  }
  const std::size_t worst_line = check->worst_line;
  report.before = std::move(check->before);
  report.after = std::move(check->after);
  if (Result<void> fine = checkOutcome(report, options, program.name(), worst_line); !fine)
    return fine.error();
  warnRemains(report, options);
  warnLeftAlone(model, report);
  return report;
}

Result<CompensatedText> compensateText(const ErrorModel& model, const std::string& name,
                                       std::string_view text, const ProgramSetup& setup,
                                       const CompensationOptions& options, Progress& progress,
                                       const ComparisonSink& compared) {
  nc::MemoryText source(name, std::string(text));
  CompensatedText result;
  const TextSink sink = [&](std::string_view piece) -> Result<void> {
    result.text += piece;
    return {};
  };
  const auto corrected = [&]() -> Result<std::unique_ptr<nc::TextSource>> {
    return std::unique_ptr<nc::TextSource>(std::make_unique<nc::MemoryText>(name, result.text));
  };
  Result<CompensationReport> report =
      compensateProgram(model, source, setup, options, sink, corrected, progress, compared);
  if (!report) return report.error();
  result.report = std::move(*report);
  return result;
}

Result<CompensationReport> compensateFile(const ErrorModel& model, const std::filesystem::path& source,
                                          const std::filesystem::path& target, const ProgramSetup& setup,
                                          const CompensationOptions& options, Progress& progress) {
  Result<std::unique_ptr<nc::TextSource>> program = nc::openTextFile(source);
  if (!program) return program.error();
  Result<AtomicFile> file = AtomicFile::create(target);
  if (!file) return file.error();
  const TextSink sink = [&](std::string_view piece) { return file->write(piece); };
  const auto corrected = [&]() -> Result<std::unique_ptr<nc::TextSource>> {
    if (Result<void> flushed = file->flush(); !flushed) return flushed.error();
    return nc::openTextFile(file->temporaryPath());
  };
  Result<CompensationReport> report =
      compensateProgram(model, **program, setup, options, sink, corrected, progress);
  if (!report) return report;
  if (Result<void> committed = file->commit(); !committed) return committed.error();
  return report;
}

}  // namespace nineline::compensation
