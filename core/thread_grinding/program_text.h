#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/thread_grinding/thread_parameters.h"
#include "core/thread_grinding/thread_path.h"

namespace nineline::thread_grinding {

/// X, Z, C as the program's words state them: mm (or diameter), mm, deg.
struct AxisWords {
  double x = 0.0;
  double z = 0.0;
  double c_deg = 0.0;
};

[[nodiscard]] AxisWords wordsOf(const ThreadPoint& point, const AxisConvention& axes);
[[nodiscard]] ThreadPoint pointOf(const AxisWords& words, const AxisConvention& axes);

/// Writes the lines of a program in Fanuc style: words that do not change are left out, numbers have a fixed
/// number of decimals and never a negative zero. Positions are given in model coordinates.
class ProgramText {
 public:
  ProgramText(const ThreadParameters& parameters, const MachineLimits& limits);

  void line(std::string_view text);
  /// In parentheses; what a control would not take in a comment is replaced.
  void comment(std::string_view text);
  /// The code on a line of its own, nothing when it is empty.
  void code(std::string_view text);

  void rapidX(double x);
  void rapidZ(double z);
  void rapidZC(double z, double gamma);
  /// G94 G01 X: the infeed at `speed`, mm/s.
  void feedX(double x, double speed);
  /// Begins a C–Z motion; the next `synchronous` block states its modal words.
  void beginSynchronous();
  /// G93 (or G94) G01 in `duration` seconds to a point.
  void synchronous(const ThreadPoint& point, double duration);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::string take() { return std::move(text_); }
  [[nodiscard]] std::size_t motionBlocks() const { return motion_blocks_; }
  [[nodiscard]] double duration() const { return duration_; }
  [[nodiscard]] double gamma() const { return position_.gamma; }
  /// The largest modulus of a word written so far.
  [[nodiscard]] double largestWord() const { return largest_word_; }

 private:
  /// " X12.345" where the word differs from the last one of its axis, else nothing.
  std::string word(std::size_t axis, char letter, double value);
  std::string feedWord(double feed);
  void rapid(const std::string& words, double seconds);

  AxisConvention axes_;
  int decimals_;
  FeedWords feed_words_;
  double linear_speed_;
  double c_speed_;
  std::string text_;
  std::array<std::string, 3> last_words_;
  std::string last_feed_;
  std::string_view modal_;  ///< motion and feed mode that are in force
  ThreadPoint position_;
  std::size_t motion_blocks_ = 0;
  double duration_ = 0.0;
  double largest_word_ = 0.0;
};

}  // namespace nineline::thread_grinding
