#include "app/cli/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/cli/interrupt.h"

namespace nineline::cli {

namespace {

void write(std::FILE* stream, std::string_view text) { std::fwrite(text.data(), 1, text.size(), stream); }

}  // namespace

Console::Console(const Options& options)
    : options_(options), shows_progress_(!options.quiet && isatty(STDERR_FILENO) == 1) {}

Console::~Console() { clearProgress(); }

void Console::result(const Json& record, std::string_view summary) {
  if (options_.json) {
    print(writeJson(record) + "\n");
  } else if (!options_.quiet) {
    print(summary);
  }
}

void Console::print(std::string_view text) {
  clearProgress();
  write(stdout, text);
}

void Console::diagnostics(const std::vector<Diagnostic>& findings, const std::string& source) {
  clearProgress();
  for (const Diagnostic& one : findings) {
    const Error place{ErrorKind::BadInput, one.code, one.text, source, one.line, one.column};
    const char* severity = one.severity == Severity::Warning ? "warning" : "error";
    const std::string times = one.count > 1 ? fmt::format(" ({} times)", one.count) : "";
    write(stderr, fmt::format("{}: {}{}\n", severity, place.message(), times));
  }
}

Error Console::refusal(const Diagnostics& findings, const std::string& source) {
  std::vector<Diagnostic> others = findings.all();
  others.erase(std::find_if(others.begin(), others.end(),
                            [](const Diagnostic& one) { return one.severity == Severity::Error; }));
  diagnostics(others, source);
  return findings.firstError(source);
}

int Console::error(const Error& error) {
  clearProgress();
  write(stderr, fmt::format("error: {}\n", error.message()));
  return static_cast<int>(error.kind);
}

void Console::plainError(std::string_view text) { write(stderr, text); }

int Console::finish() {
  clearProgress();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return 0;
  return error(badInput("stdout", "The result cannot be written to the standard output."));
}

void Console::report(double fraction, const std::string& what) {
  if (!shows_progress_) return;
  const std::string line =
      fraction >= 0.0 ? fmt::format("{}: {:.0f} %", what, 100.0 * fraction) : fmt::format("{} ...", what);
  if (line == shown_) return;
  clearProgress();
  write(stderr, line);
  shown_ = line;
}

bool Console::isCancelled() const { return isInterrupted(); }

void Console::clearProgress() {
  if (shown_.empty()) return;
  write(stderr, "\r\x1b[K");
  shown_.clear();
}

}  // namespace nineline::cli
