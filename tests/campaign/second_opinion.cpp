#include "tests/campaign/second_opinion.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "core/base/text.h"

namespace nineline::campaign {

namespace {

constexpr double kSmall = 0.3;  // mm, deg: more is another place

struct Call {
  std::string text;             // without line numbers
  std::vector<double> numbers;  // of the last motion before, or of an offset
  bool offset = false;
};

std::vector<double> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  for (const char* p = text.c_str(); *p != '\0';) {
    char* end = nullptr;
    const double value = std::strtod(p, &end);
    if (end != p) numbers.push_back(value);
    p = end != p ? end : p + 1;
  }
  return numbers;
}

/// Calls other than motions; each knows where the machine stood.
std::vector<Call> callsOf(const std::string& text) {
  std::vector<Call> calls;
  std::vector<double> place;
  for (const std::string_view line : split(text, '\n')) {
    const std::size_t open = line.find('(');
    if (open == std::string_view::npos) continue;
    const std::size_t blank = line.substr(0, open).find_last_of(" \t");
    const std::string call(trimmed(line.substr(blank == std::string_view::npos ? 0 : blank + 1)));
    const std::string arguments = call.substr(call.find('('));
    if (call.starts_with("STRAIGHT_TRAVERSE") || call.starts_with("STRAIGHT_FEED")) {
      place = numbersIn(arguments);
    } else if (call.starts_with("ARC_FEED")) {
      place.clear();  // its numbers depend on the plane; the next straight motion is compared again
    } else if (call.starts_with("SET_G92_OFFSET")) {
      calls.push_back({"SET_G92_OFFSET", numbersIn(arguments), true});
      place.clear();
    } else {
      calls.push_back({call, place, false});
    }
  }
  return calls;
}

bool isNear(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return a.empty() || b.empty();  // one of them stands at the end of an arc
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(std::abs(a[i] - b[i]) <= kSmall)) return false;
  }
  return true;
}

}  // namespace

SecondOpinion::SecondOpinion(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
}

bool SecondOpinion::isInstalled() { return std::system("command -v rs274 >/dev/null 2>&1") == 0; }

std::string SecondOpinion::read(const std::string& program, double tool_length) const {
  std::string text;
  for (const std::string_view line : split(program, '\n')) {
    if (!line.starts_with('O')) text += std::string(line) + "\n";
  }
  while (text.ends_with("\n\n")) text.pop_back();
  std::ofstream(folder_ / "program.ngc", std::ios::binary) << text;
  std::ofstream(folder_ / "tools.tbl") << fmt::format("T1 P1 Z{:.6f} D5\n", tool_length);
  const std::string command = fmt::format(
      "cd '{0}' && rm -f rs274ngc.var && HOME='{0}' timeout 60 rs274 -t tools.tbl -g program.ngc 2>&1",
      folder_.string());
  std::string output;
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  std::array<char, 4096> buffer;
  for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    output.append(buffer.data(), got);
  ::pclose(pipe);
  return output;
}

bool isComplete(const std::string& calls) { return calls.find("PROGRAM_END") != std::string::npos; }

std::string reasonOf(const std::string& calls) {
  std::string reason;
  for (const std::string_view line : split(calls, '\n')) {
    if (!trimmed(line).empty()) reason = std::string(trimmed(line));
  }
  return reason.substr(0, 200);
}

std::string changedMeaning(const std::string& original_calls, const std::string& corrected_calls) {
  const std::vector<Call> a = callsOf(original_calls);
  const std::vector<Call> b = callsOf(corrected_calls);
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    if (a[i].text != b[i].text) return fmt::format("call {}: {} became {}", i + 1, a[i].text, b[i].text);
    if (!isNear(a[i].numbers, b[i].numbers))
      return fmt::format("call {}: {} at another place", i + 1, a[i].text);
  }
  if (a.size() != b.size()) return fmt::format("{} calls became {}", a.size(), b.size());
  return {};
}

}  // namespace nineline::campaign
