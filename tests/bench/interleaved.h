#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <vector>

namespace nineline::bench {

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

/// Processor time of this thread, ns: what others do on the machine counts less.
inline double processorNanoseconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

/// Runs `ours` and `reference` in turn on the same work of `items` items and reports both medians and their
/// ratio: on a machine that others use, only the ratio means something. `goal`: the ratio of performance.md.
template <typename Ours, typename Reference>
void measureInTurn(benchmark::State& state, double items, double goal, Ours ours, Reference reference) {
  std::vector<double> own;
  std::vector<double> other;
  ours();
  reference();
  for (auto _ : state) {
    const double begin = processorNanoseconds();
    ours();
    const double middle = processorNanoseconds();
    reference();
    own.push_back((middle - begin) / items);
    other.push_back((processorNanoseconds() - middle) / items);
    state.SetIterationTime(1e-9 * (middle - begin));
  }
  state.counters["ours_ns"] = median(own);
  state.counters["reference_ns"] = median(other);
  state.counters["ratio"] = median(own) / median(other);
  state.counters["goal"] = goal;
}

}  // namespace nineline::bench
