#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/campaign/campaign_machine.h"

namespace nineline::campaign {

/// A drawn program, and what it is written in.
struct DrawnProgram {
  std::string text;
  bool inch = false;
  double tool_length = 0.0;  ///< mm, of H1; 0: not used
};

/// Writes programs of lines, arcs in all planes and helices as Fanuc controls and LinuxCNC both understand
/// them; every line carries an N number or a comment of its own, by which it is found again.
class ProgramDrawer {
 public:
  ProgramDrawer(Random& random, const PlainMachine& machine, int blocks);
  [[nodiscard]] DrawnProgram draw();

 private:
  /// Words in whole steps of the last decimal, so that nothing is lost by rounding.
  using Steps = std::array<long long, 9>;
  struct Room {
    double low = 0.0, high = 0.0;  // of the program's words: mm (inch), deg
  };
  void put(const std::string& words);
  void start();
  void step();
  void line(bool rapid);
  void arc();
  void modal();
  void offset();
  [[nodiscard]] std::string number(long long steps) const;
  [[nodiscard]] std::string word(std::size_t joint, long long target) const;
  [[nodiscard]] std::string code(int motion);
  [[nodiscard]] long long drawn(std::size_t joint);
  [[nodiscard]] long long stepsOf(double value) const;
  [[nodiscard]] int find(char letter) const;
  [[nodiscard]] bool isInside(std::size_t joint, long long steps) const;

  Random& random_;
  const PlainMachine& machine_;
  int blocks_;
  DrawnProgram program_;
  std::array<Room, 9> room_{};
  Steps at_{};
  double scale_ = 1.0;  // steps of one unit
  bool incremental_ = false;
  bool tags_by_number_ = true;
  int line_number_ = 0;
  int motion_ = -1;
  int plane_ = 17;
};

}  // namespace nineline::campaign
