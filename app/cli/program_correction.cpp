#include "app/cli/program_correction.h"

#include "app/cli/path_file.h"

namespace nineline::cli {

Result<CorrectionFiles> CorrectionFiles::create(const std::string& program, const std::string& path) {
  Result<AtomicFile> program_file = AtomicFile::create(program);
  if (!program_file) return program_file.error();
  CorrectionFiles files{std::move(*program_file), std::nullopt};
  if (path.empty()) return files;
  Result<AtomicFile> path_file = AtomicFile::create(path);
  if (!path_file) return path_file.error();
  files.path.emplace(std::move(*path_file));
  return files;
}

Result<void> CorrectionFiles::commit() {
  if (path) {
    if (Result<void> committed = path->commit(); !committed) return committed;
  }
  return program.commit();
}

Result<compensation::CompensationReport> correctProgram(const errors::ErrorModel& model,
                                                        const std::string& source,
                                                        const simulation::ProgramSetup& setup,
                                                        const compensation::CompensationOptions& options,
                                                        CorrectionFiles& files, Progress& progress,
                                                        const compensation::ComparisonSink& compared) {
  const Result<std::unique_ptr<nc::TextSource>> program = nc::openTextFile(source);
  if (!program) return program.error();
  const auto open_corrected = [&files]() -> Result<std::unique_ptr<nc::TextSource>> {
    if (const Result<void> flushed = files.program.flush(); !flushed) return flushed.error();
    return nc::openTextFile(files.program.temporaryPath());
  };
  Result<void> written;  // its failure is of the output, not of the block that was being corrected
  const auto sink = [&files, &written](std::string_view text) { return written = files.program.write(text); };
  Result<compensation::CompensationReport> report = compensation::compensateProgram(
      model, **program, setup, options, sink, open_corrected, progress, compared);
  if (!written) return written.error();
  if (!report || !files.path) return report;
  const Result<std::unique_ptr<nc::TextSource>> corrected = open_corrected();
  if (!corrected) return corrected.error();
  const Result<simulation::SimulationReport> path =
      simulateToFile(model, **corrected, setup, *files.path, progress);
  if (!path) return path.error();
  return report;
}

}  // namespace nineline::cli
