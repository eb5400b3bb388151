#include "core/thread_grinding/program_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/contract.h"
#include "core/base/text.h"

namespace nineline::thread_grinding {
namespace {
constexpr std::string_view kRapid = "G00";
constexpr std::string_view kFeed = "G94 G01";
constexpr std::string_view kInverseTime = "G93 G01";
constexpr int kFeedDecimals = 3;
// Where the machine's rapid speeds are unknown they only enter the time estimate.
constexpr double kUsualRapid = 100.0;                                   // mm/s
constexpr double kUsualSpindle = perSecondFromPerMinute(40.0 * kTurn);  // rad/s
}  // namespace

AxisWords wordsOf(const ThreadPoint& point, const AxisConvention& axes) {
  return {axes.x_sign * axes.x_factor * (point.x - axes.x_zero), axes.z_sign * (point.z - axes.z_zero),
          axes.c_sign * degFromRad(point.gamma - axes.c_zero)};
}

ThreadPoint pointOf(const AxisWords& words, const AxisConvention& axes) {
  return {axes.x_sign * words.x / axes.x_factor + axes.x_zero, axes.z_sign * words.z + axes.z_zero,
          axes.c_sign * radFromDeg(words.c_deg) + axes.c_zero};
}

ProgramText::ProgramText(const ThreadParameters& parameters, const MachineLimits& limits)
    : axes_(parameters.axes),
      decimals_(parameters.decimals),
      feed_words_(parameters.feed_words),
      linear_speed_(limits.z_speed.value_or(kUsualRapid)),
      c_speed_(limits.c_speed.value_or(kUsualSpindle)) {}

void ProgramText::line(std::string_view text) {
  text_ += text;
  text_ += '\n';
}

void ProgramText::comment(std::string_view text) {
  std::string plain = upper(text);
  for (char& letter : plain) {
    const bool printable = letter >= ' ' && letter <= '~';
    if (!printable || letter == '(' || letter == ')' || letter == '%' || letter == ';') letter = ' ';
  }
  line(fmt::format("({})", plain));
}

void ProgramText::code(std::string_view text) {
  if (!trimmed(text).empty()) line(trimmed(text));
}

std::string ProgramText::word(std::size_t axis, char letter, double value) {
  const std::string digits = fixed(value, decimals_);
  NL_EXPECTS(!digits.empty(), letter, value);
  largest_word_ = std::max(largest_word_, std::abs(value));
  if (digits == last_words_[axis]) return {};
  last_words_[axis] = digits;
  return fmt::format(" {}{}", letter, digits);
}

std::string ProgramText::feedWord(double feed) {
  std::string digits = fixed(feed, kFeedDecimals);
  NL_EXPECTS(!digits.empty(), feed);
  return digits;
}

void ProgramText::rapid(const std::string& words, double seconds) {
  duration_ += seconds;
  if (words.empty()) return;
  line(modal_ == kRapid ? words.substr(1) : fmt::format("{}{}", kRapid, words));
  modal_ = kRapid;
  ++motion_blocks_;
}

void ProgramText::rapidX(double x) {
  const double seconds = std::abs(x - position_.x) / linear_speed_;
  position_.x = x;
  rapid(word(0, 'X', wordsOf(position_, axes_).x), seconds);
}

void ProgramText::rapidZ(double z) {
  const double seconds = std::abs(z - position_.z) / linear_speed_;
  position_.z = z;
  rapid(word(1, 'Z', wordsOf(position_, axes_).z), seconds);
}

void ProgramText::rapidZC(double z, double gamma) {
  const double seconds =
      std::max(std::abs(z - position_.z) / linear_speed_, std::abs(gamma - position_.gamma) / c_speed_);
  position_.z = z;
  position_.gamma = gamma;
  const AxisWords words = wordsOf(position_, axes_);
  const std::string z_word = word(1, 'Z', words.z);
  rapid(z_word + word(2, 'C', words.c_deg), seconds);
}

void ProgramText::feedX(double x, double speed) {
  duration_ += std::abs(x - position_.x) / speed;
  position_.x = x;
  const std::string x_word = word(0, 'X', wordsOf(position_, axes_).x);
  if (x_word.empty()) return;
  last_feed_ = feedWord(perMinuteFromPerSecond(speed));
  line(fmt::format("{}{} F{}", kFeed, x_word, last_feed_));
  modal_ = kFeed;
  ++motion_blocks_;
}

void ProgramText::beginSynchronous() { modal_ = {}; }

void ProgramText::synchronous(const ThreadPoint& point, double duration) {
  NL_EXPECTS(duration > 0.0, duration);
  const bool inverse = feed_words_ == FeedWords::InverseTime;
  const double path =
      std::hypot(point.x - position_.x, point.z - position_.z, degFromRad(point.gamma - position_.gamma));
  position_ = point;
  const AxisWords words = wordsOf(point, axes_);
  std::string blocks = word(0, 'X', words.x);
  blocks += word(1, 'Z', words.z);
  blocks += word(2, 'C', words.c_deg);
  const std::string feed = feedWord(perMinuteFromPerSecond((inverse ? 1.0 : path) / duration));
  const std::string_view mode = inverse ? kInverseTime : kFeed;
  // With G93 the control wants an F in every block.
  const std::string feed_word =
      inverse || modal_ != mode || feed != last_feed_ ? fmt::format(" F{}", feed) : "";
  const std::string text = blocks + feed_word;
  line(modal_ == mode ? text.substr(1) : fmt::format("{}{}", mode, text));
  modal_ = mode;
  last_feed_ = feed;
  duration_ += duration;
  ++motion_blocks_;
}

}  // namespace nineline::thread_grinding
