#include "core/compensation/compensation.h"

#include <chrono>

#include "core/base/file.h"
#include "core/compensation/program_corrector.h"
#include "core/compensation/verification.h"

namespace nineline::compensation {

namespace {

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

}  // namespace

Result<CompensationReport> compensateProgram(
    const ErrorModel& model, nc::TextSource& program, const ProgramSetup& setup,
    const CompensationOptions& options, const TextSink& sink,
    const std::function<Result<std::unique_ptr<nc::TextSource>>()>& corrected_text, Progress& progress,
    const ComparisonSink& compared) {
  if (Result<void> fine = checkOptions(model, options); !fine) return fine.error();
  if (Result<void> known = simulation::requireConditions(model, setup); !known) return known.error();
  const auto begin = std::chrono::steady_clock::now();
  ProgramCorrector corrector(model, setup, options, program, sink);
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
  report.before = std::move(check->before);
  report.after = std::move(check->after);
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
