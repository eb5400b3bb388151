#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/nc/block_writer.h"
#include "core/nc/interpreter.h"
#include "tests/bench/interleaved.h"

// Rows NC-1 and NC-3 of performance.md: reading against LinuxCNC's `rs274` (one process for each round, its
// processor time, start included), writing against a formatter by hand.

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

std::size_t motionsOf(TextSource& text, const InterpreterOptions& options) {
  Interpreter interpreter(text, options);
  std::size_t motions = 0;
  for (;;) {
    const Result<const ExecutedBlock*> block = interpreter.next();
    if (!block) std::abort();
    if (!*block) return motions;
    motions += (*block)->motions.size();
  }
}

/// G01 blocks along a curve: `five` adds A and C words.
std::string program(bool five) {
  std::string text = "G21 G90 G17 G94\nG01 F1200.\n";
  for (int i = 0; i < kBlocks; ++i) {
    const double t = 0.001 * i;
    text += fmt::format("X{:.3f} Y{:.3f} Z{:.3f}", 50 * std::cos(t), 50 * std::sin(t), 10 * std::sin(3 * t));
    if (five) text += fmt::format(" A{:.4f} C{:.4f}", 20 * std::sin(t), 3.7 * t);
    text += '\n';
  }
  return text + "M30\n";
}

void interpret(benchmark::State& state, bool five) {
  MemoryText text("bench.nc", program(five));
  InterpreterOptions options;
  options.axes = layoutOf(five ? "XYZAC" : "XYZ");
  std::size_t motions = 0;
  for (auto _ : state) motions += motionsOf(text, options);
  benchmark::DoNotOptimize(motions);
  state.SetItemsProcessed(state.iterations() * kBlocks);
}

double childSeconds() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// Ours and `rs274` in turn on the same file.
void againstRs274(benchmark::State& state, bool five) {
  if (std::system("command -v rs274 >/dev/null 2>&1") != 0) return state.SkipWithError("needs rs274");
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "nineline-nc-benchmark";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "p.ngc") << program(five);
  const std::string command = fmt::format(
      "cd '{0}' && HOME='{0}' rs274 -g p.ngc canon.txt >/dev/null 2>&1 </dev/null", folder.string());
  InterpreterOptions options;
  options.axes = layoutOf(five ? "XYZAC" : "XYZ");
  MemoryText text("bench.nc", program(five));
  std::vector<double> own;
  std::vector<double> other;
  for (auto _ : state) {
    const double begin = bench::processorNanoseconds();
    if (motionsOf(text, options) != kBlocks) std::abort();
    const double seconds = 1e-9 * (bench::processorNanoseconds() - begin);
    const double before = childSeconds();
    if (std::system(command.c_str()) != 0) return state.SkipWithError("rs274 refuses the program");
    own.push_back(seconds / kBlocks * 1e9);
    other.push_back((childSeconds() - before) / kBlocks * 1e9);
    state.SetIterationTime(seconds);
  }
  std::filesystem::remove_all(folder);
  state.counters["ours_ns"] = bench::median(own);
  state.counters["reference_ns"] = bench::median(other);
  state.counters["times_faster"] = bench::median(other) / bench::median(own);
  state.counters["goal"] = five ? 40 : 60;
}

/// A number with four decimals, as one writes it by hand.
char* putByHand(char* out, char letter, double value) {
  *out++ = letter;
  long scaled = std::lrint(value * 1e4);
  if (scaled < 0) {
    *out++ = '-';
    scaled = -scaled;
  }
  char digits[20];
  int count = 0;
  long whole = scaled / 10000;
  do digits[count++] = static_cast<char>('0' + whole % 10);
  while ((whole /= 10) != 0);
  while (count > 0) *out++ = digits[--count];
  *out++ = '.';
  long fraction = scaled % 10000;
  for (int i = 3; i >= 0; --i, fraction /= 10) out[i] = static_cast<char>('0' + fraction % 10);
  return out + 4;
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
  constexpr int kLines = 1000;
  const auto ours = [&] {
    for (int i = 0; i < kLines; ++i) {
      out.clear();
      shift += 0.0013;
      BlockEditor editor(*(*executed)->block, style);
      for (const Word& word : (*executed)->block->words) {
        if (!editor.setValue(word, word.value + shift, 4)) std::abort();
      }
      editor.appendTo(out);
      benchmark::DoNotOptimize(out.data());
    }
  };
  std::array<char, 256> line;
  const auto by_hand = [&] {
    for (int i = 0; i < kLines; ++i) {
      shift += 0.0013;
      char* p = line.data();
      for (const Word& word : (*executed)->block->words) p = putByHand(p, word.letter, word.value + shift);
      benchmark::DoNotOptimize(p);
    }
  };
  bench::measureInTurn(state, kLines, 1.3, ours, by_hand);
}

BENCHMARK_CAPTURE(interpret, three_axes_100k_blocks, false);
BENCHMARK_CAPTURE(interpret, five_axes_100k_blocks, true);
BENCHMARK_CAPTURE(againstRs274, NC1_three_axes, false)->UseManualTime()->Iterations(3);
BENCHMARK_CAPTURE(againstRs274, NC1_five_axes, true)->UseManualTime()->Iterations(3);
BENCHMARK_CAPTURE(writeBlock, NC3_three_words, false)->UseManualTime();
BENCHMARK_CAPTURE(writeBlock, NC3_five_words, true)->UseManualTime();

}  // namespace
}  // namespace nineline::nc

BENCHMARK_MAIN();
