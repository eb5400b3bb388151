#include "tests/core/nc/program_runner.h"

namespace nineline::nc::testing {

bool ProgramRun::warned(const std::string& text) const {
  for (const Diagnostic& one : diagnostics.all()) {
    if (one.severity == Severity::Warning && one.text.find(text) != std::string::npos) return true;
  }
  return false;
}

AxisLayout axesOf(const std::string& letters) {
  AxisLayout layout;
  for (const char letter : letters) {
    layout.axes[static_cast<std::size_t>(layout.count++)] = {{letter, 0}, letter <= 'C', false};
  }
  return layout;
}

InterpreterOptions optionsFor(const std::string& letters, Dialect dialect) {
  InterpreterOptions options;
  options.axes = axesOf(letters);
  options.dialect = dialect;
  options.most_jumps = 10'000;
  return options;
}

ProgramRun run(const std::string& program, InterpreterOptions options) {
  ProgramRun out;
  MemoryText text("test.nc", program);
  Interpreter interpreter(text, std::move(options));
  for (;;) {
    const Result<const ExecutedBlock*> next = interpreter.next();
    if (!next) {
      out.error = next.error().message();
      out.code = next.error().code;
      out.line = next.error().line;
      out.column = next.error().column;
    }
    if (!next || !*next) break;
    const ExecutedBlock& block = **next;
    RunBlock kept{block.block->line,
                  std::string(block.block->text),
                  {block.motions.begin(), block.motions.end()},
                  *block.frame,
                  block.rewritable,
                  block.feed_stated,
                  block.block->skipped,
                  block.repeated,
                  block.has_word,
                  block.motion_code,
                  block.depth};
    out.motions.insert(out.motions.end(), kept.motions.begin(), kept.motions.end());
    out.blocks.push_back(std::move(kept));
  }
  out.diagnostics = interpreter.diagnostics();
  out.dialect = interpreter.dialect();
  return out;
}

ProgramRun runFanuc(const std::string& program, const std::string& letters) {
  return run(program, optionsFor(letters, Dialect::Fanuc));
}
ProgramRun runSiemens(const std::string& program, const std::string& letters) {
  return run(program, optionsFor(letters, Dialect::Siemens));
}
ProgramRun runLinuxCnc(const std::string& program, const std::string& letters) {
  return run(program, optionsFor(letters, Dialect::LinuxCnc));
}

}  // namespace nineline::nc::testing
