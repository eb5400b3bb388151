#include "tests/campaign/campaign_program.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"

namespace nineline::campaign {

ProgramDrawer::ProgramDrawer(Random& random, const PlainMachine& machine, int blocks)
    : random_(random), machine_(machine), blocks_(blocks) {}

int ProgramDrawer::find(char letter) const {
  for (std::size_t i = 0; i < machine_.joints.size(); ++i) {
    if (machine_.joints[i].letter == letter) return static_cast<int>(i);
  }
  return -1;
}

long long ProgramDrawer::stepsOf(double value) const { return std::llround(value * scale_); }

bool ProgramDrawer::isInside(std::size_t joint, long long steps) const {
  const double value = static_cast<double>(steps) / scale_;
  return value >= room_[joint].low && value <= room_[joint].high;
}

long long ProgramDrawer::drawn(std::size_t joint) {
  return stepsOf(random_.between(room_[joint].low, room_[joint].high));
}

std::string ProgramDrawer::number(long long steps) const {
  const int decimals = static_cast<int>(std::lround(std::log10(scale_)));
  std::string text = fmt::format("{:.{}f}", static_cast<double>(steps) / scale_, decimals);
  while (text.ends_with('0')) text.pop_back();  // X12. as on Fanuc controls
  return text == "-0." ? "0." : text;
}

std::string ProgramDrawer::word(std::size_t joint, long long target) const {
  return fmt::format(" {}{}", machine_.joints[joint].letter,
                     number(incremental_ ? target - at_[joint] : target));
}

void ProgramDrawer::put(const std::string& words) {
  line_number_ += 10;
  program_.text += tags_by_number_ ? fmt::format("N{} {}\n", line_number_, words)
                                   : fmt::format("{} (B{})\n", words, line_number_);
}

/// The motion code, left out where it is in force already, mostly.
std::string ProgramDrawer::code(int motion) {
  const bool left_out = motion == motion_ && random_.whole(0, 3) != 0;
  motion_ = motion;
  if (left_out) return {};
  return random_.whole(0, 1) == 1 ? fmt::format("G{:02d}", motion) : fmt::format("G{}", motion);
}

void ProgramDrawer::start() {
  program_.inch = random_.whole(0, 4) == 0;
  tags_by_number_ = random_.whole(0, 3) != 0;
  const double unit = program_.inch ? 1.0 / kMillimetresPerInch : 1.0;
  scale_ = program_.inch ? 1e4 : 1e3;
  std::string offsets;
  for (std::size_t i = 0; i < machine_.joints.size(); ++i) {
    const PlainJoint& joint = machine_.joints[i];
    const bool wheel = machine_.structure == Structure::Grinder && joint.letter == 'X';
    const double offset = joint.rotary ? 0.0 : std::round(random_.between(-60.0, 60.0) * 8.0) / 8.0;
    const double factor = joint.rotary ? 1.0 : unit * (joint.diameter ? 2.0 : 1.0);
    room_[i] = {-120.0, 120.0};
    if (wheel) room_[i] = {60.0, 160.0};
    if (joint.letter == 'A') room_[i] = {15.0, 75.0};
    if (joint.letter == 'C') room_[i] = {-400.0, 400.0};
    // In words: the machine position less the offset.
    const long long shift = stepsOf(offset * factor);
    const double word = static_cast<double>(shift) / scale_;
    room_[i] = {room_[i].low * factor - word, room_[i].high * factor - word};
    if (!joint.rotary) offsets += fmt::format(" {}{}", joint.letter, number(shift));
  }
  if (random_.whole(0, 1) == 1) program_.text += fmt::format("O{:04d} (CAMPAIGN)\n", random_.whole(1, 7999));
  put(fmt::format("G{} G90 G94 G40 G49 G80 G17", program_.inch ? 20 : 21));
  put("G10 L2 P1" + offsets);
  put("G54");
  put("T1 M6 (TOOL)");
  put(fmt::format("S{} M3", random_.whole(100, 4000)));
  if (machine_.structure != Structure::Grinder && random_.whole(0, 2) == 0) {
    program_.tool_length = 0.5 * random_.whole(10, 80);
    put("G43 H1");
  }
  put(fmt::format("F{}", program_.inch ? random_.whole(5, 40) : random_.whole(100, 900)));
  std::string words = code(0);
  for (std::size_t i = 0; i < machine_.joints.size(); ++i) {
    const long long target = drawn(i);
    words += word(i, target);
    at_[i] = target;
  }
  put(words);
}

void ProgramDrawer::line(bool rapid) {
  std::string words;
  Steps target = at_;
  for (std::size_t i = 0; i < machine_.joints.size(); ++i) {
    if (random_.whole(0, 1) == 0) continue;
    // Mostly short ways, as CAM systems write them; now and then across the room.
    const long long far = drawn(i);
    const double part = random_.whole(0, 2) == 0 ? 1.0 : 0.1;
    target[i] = at_[i] + std::llround(part * static_cast<double>(far - at_[i]));
    words += word(i, target[i]);
  }
  if (words.empty()) return;
  // A feed of rotary axes alone is in degrees and cannot take linear words: no part of this campaign.
  const auto first_linear = static_cast<std::size_t>(find('Z'));
  if (!rapid && words.find_first_of("XYZ") == std::string::npos)
    words += word(first_linear, at_[first_linear]);
  words = code(rapid ? 0 : 1) + words;
  at_ = target;
  if (!rapid && random_.whole(0, 5) == 0)
    words += fmt::format(" F{}", program_.inch ? random_.whole(5, 40) : random_.whole(100, 900));
  if (random_.whole(0, 11) == 0) words += random_.whole(0, 1) == 1 ? " M8" : " M9";
  put(words);
}

void ProgramDrawer::arc() {
  const char* const axes = plane_ == 17 ? "XYZIJ" : plane_ == 18 ? "ZXYKI" : "YZXJK";
  const int first = find(axes[0]);
  const int second = find(axes[1]);
  if (first < 0 || second < 0) return;
  const auto a = static_cast<std::size_t>(first);
  const auto b = static_cast<std::size_t>(second);
  const double factor_a = machine_.joints[a].diameter ? 2.0 : 1.0;
  const double factor_b = machine_.joints[b].diameter ? 2.0 : 1.0;
  const double unit = program_.inch ? 1.0 / kMillimetresPerInch : 1.0;
  const double radius = random_.between(2.0, 30.0) * unit;
  const double begin = random_.between(0.0, kTurn);
  const bool closed = random_.whole(0, 9) == 0;
  const double sweep = closed ? kTurn : random_.between(0.2, 5.8);
  const bool left = random_.whole(0, 1) == 1;
  const double end = begin + (left ? sweep : -sweep);
  const bool by_radius = !closed && random_.whole(0, 3) == 0 && std::abs(sweep - kPi) > 0.3;
  const auto centre = [&](std::size_t joint, double factor, double part) {
    return static_cast<double>(at_[joint]) / scale_ - factor * radius * part;
  };
  const double centre_a = centre(a, factor_a, std::cos(begin));
  const double centre_b = centre(b, factor_b, std::sin(begin));
  for (const double side : {-1.0, 1.0}) {
    if (!isInside(a, stepsOf(centre_a + side * factor_a * radius))) return;
    if (!isInside(b, stepsOf(centre_b + side * factor_b * radius))) return;
  }
  std::string words = code(left ? 3 : 2);
  Steps target = at_;
  if (!closed) {
    target[a] = stepsOf(centre_a + factor_a * radius * std::cos(end));
    target[b] = stepsOf(centre_b + factor_b * radius * std::sin(end));
    words += word(a, target[a]) + word(b, target[b]);
  }
  for (std::size_t i = 0; i < machine_.joints.size(); ++i) {
    const bool helix = machine_.joints[i].letter == axes[2] || machine_.joints[i].rotary;
    if (i == a || i == b || !helix || random_.whole(0, 2) != 0) continue;
    target[i] = at_[i] + (drawn(i) - at_[i]) / 8;
    words += word(i, target[i]);
  }
  if (by_radius) {
    words += fmt::format(" R{}", number(stepsOf(sweep > kPi ? -radius : radius)));
  } else {
    words += fmt::format(" {}{} {}{}", axes[3], number(stepsOf(-radius * std::cos(begin))), axes[4],
                         number(stepsOf(-radius * std::sin(begin))));
  }
  at_ = target;
  put(words);
}

void ProgramDrawer::modal() {
  switch (random_.whole(0, 7)) {
    case 0:
      return put(fmt::format("S{}", random_.whole(100, 4000)));
    case 1:
      return put("G4 P0.2");
    case 2:
      return put(fmt::format("(SECTION {}; X1. Y2. ARE NO WORDS HERE)", random_.whole(1, 99)));
    case 3:
      return put(random_.whole(0, 1) == 1 ? "M8" : "M9");
    case 4:
      return put(fmt::format("F{}", program_.inch ? random_.whole(5, 40) : random_.whole(100, 900)));
    case 5:
      incremental_ = !incremental_;
      return put(incremental_ ? "G91" : "G90");
    case 6:
      return offset();
    default:
      plane_ = 17 + random_.whole(0, 2);
      return put(fmt::format("G{}", plane_));
  }
}

/// The present place gets another name; the room moves with it.
void ProgramDrawer::offset() {
  if (machine_.structure == Structure::Grinder || random_.whole(0, 2) != 0) return;
  std::string words = "G92";
  for (std::size_t i = 0; i < machine_.joints.size(); ++i) {
    if (machine_.joints[i].rotary || random_.whole(0, 1) == 0) continue;
    const long long by = stepsOf(random_.between(-5.0, 5.0));
    at_[i] += by;
    room_[i].low += static_cast<double>(by) / scale_;
    room_[i].high += static_cast<double>(by) / scale_;
    words += fmt::format(" {}{}", machine_.joints[i].letter, number(at_[i]));
  }
  if (words != "G92") put(words);
}

void ProgramDrawer::step() {
  if (machine_.structure == Structure::Grinder && plane_ != 18) {
    plane_ = 18;
    put("G18");
  }
  const int choice = random_.whole(0, 9);
  if (choice <= 3) return line(false);
  if (choice == 4) return line(true);
  if (choice <= 7) return arc();
  modal();
}

DrawnProgram ProgramDrawer::draw() {
  program_ = {};
  start();
  for (int i = 0; i < blocks_; ++i) step();
  put("M5");
  put("M30");
  return program_;
}

}  // namespace nineline::campaign
