#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "core/nc/block_writer.h"
#include "core/nc/interpreter.h"

namespace nineline::nc {
namespace {

constexpr int kBlocks = 100'000;

AxisLayout layoutOf(const char* letters) {
  AxisLayout layout;
  for (; *letters != '\0'; ++letters) {
    layout.axes[static_cast<std::size_t>(layout.count++)] = {{*letters, 0}, *letters <= 'C', false};
  }
  return layout;
}

/// G01 blocks along a curve: `five` adds A and C words.
std::string program(bool five) {
  std::string text = "%\nO1000\nG21 G90 G17 G94\nG01 F1200.\n";
  for (int i = 0; i < kBlocks; ++i) {
    const double t = 0.001 * i;
    text += fmt::format("X{:.3f} Y{:.3f} Z{:.3f}", 50 * std::cos(t), 50 * std::sin(t), 10 * std::sin(3 * t));
    if (five) text += fmt::format(" A{:.4f} C{:.4f}", 20 * std::sin(t), 3.7 * t);
    text += '\n';
  }
  return text + "M30\n%\n";
}

void interpret(benchmark::State& state, bool five) {
  MemoryText text("bench.nc", program(five));
  InterpreterOptions options;
  options.axes = layoutOf(five ? "XYZAC" : "XYZ");
  std::size_t motions = 0;
  for (auto _ : state) {
    Interpreter interpreter(text, options);
    for (;;) {
      const Result<const ExecutedBlock*> block = interpreter.next();
      if (!block) std::abort();
      if (!*block) break;
      motions += (*block)->motions.size();
    }
  }
  benchmark::DoNotOptimize(motions);
  state.SetItemsProcessed(state.iterations() * kBlocks);
}

void writeBlock(benchmark::State& state, bool five) {
  Block block;
  block.line = 1;
  block.text = five ? "X12.345 Y-6.789 Z1.234 A17.1234 C-3.4567" : "X12.345 Y-6.789 Z1.234";
  NumberStyle style;
  MemoryText text("line", std::string(block.text));
  InterpreterOptions options;
  options.axes = layoutOf(five ? "XYZAC" : "XYZ");
  Interpreter interpreter(text, options);
  const Result<const ExecutedBlock*> executed = interpreter.next();
  if (!executed || !*executed) std::abort();
  std::string out;
  out.reserve(256);
  double shift = 0.0;
  for (auto _ : state) {
    out.clear();
    shift += 0.0013;
    BlockEditor editor(*(*executed)->block, style);
    for (const Word& word : (*executed)->block->words) {
      if (!editor.setValue(word, word.value + shift, 4)) std::abort();
    }
    editor.appendTo(out);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK_CAPTURE(interpret, three_axes_100k_blocks, false);
BENCHMARK_CAPTURE(interpret, five_axes_100k_blocks, true);
BENCHMARK_CAPTURE(writeBlock, three_words, false);
BENCHMARK_CAPTURE(writeBlock, five_words, true);

}  // namespace
}  // namespace nineline::nc

BENCHMARK_MAIN();
