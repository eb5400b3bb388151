#include "core/nc/interpreter.h"

#include "core/nc/step.h"

namespace nineline::nc {

struct Interpreter::State : Execution {
  using Execution::Execution;
};

Interpreter::Interpreter(TextSource& source, InterpreterOptions options)
    : state_(std::make_unique<State>(source, std::move(options))) {
  Execution& e = *state_;
  const Result<DialectSigns> signs = recogniseDialect(source);
  if (signs) {
    e.signs = *signs;
  } else {
    e.failure = signs.error();
  }
  e.dialect = e.options.dialect.value_or(e.signs.dialect);
  e.codes = &codeTable(e.dialect);
  e.parameters = std::make_unique<Parameters>(e.dialect, *e.system);
  setUpAxes(e);
  loadOffsets(e);
}

Interpreter::~Interpreter() = default;

Result<const ExecutedBlock*> Interpreter::next() {
  Execution& e = *state_;
  if (e.failure) return *e.failure;
  if (e.ended) return static_cast<const ExecutedBlock*>(nullptr);
  if (step(e)) return static_cast<const ExecutedBlock*>(&e.executed);
  if (e.failure) return *e.failure;
  return static_cast<const ExecutedBlock*>(nullptr);
}

const Diagnostics& Interpreter::diagnostics() const { return state_->diagnostics; }
Dialect Interpreter::dialect() const { return state_->dialect; }

}  // namespace nineline::nc
