#include <fmt/format.h>

#include <cmath>

#include "core/postprocessing/control_writer.h"

namespace nineline::postprocessing {

namespace {

class GCodeWriter final : public ControlWriter {
 public:
  using ControlWriter::ControlWriter;

  void begin(const std::string& name) override {
    const std::string title = harmless(name.empty() ? "PROGRAM" : name, options_.control);
    switch (options_.control) {
      case Control::Siemens:
        put("; " + title);
        put("G71 G17 G40 G54 G90 G94");
        if (!options_.tip_control) put("FGROUP(" + axisNames() + ")");
        return;
      case Control::LinuxCnc:
        put("(" + title + ")");
        put("G21 G17 G40 G49 G54 G80 G90 G94");
        return;
      default:
        put("%");
        put(fmt::format("O{:04d} ({})", options_.program_number, title));
        put("G21 G17 G40 G49 G54 G80 G90 G94");
    }
  }

  void event(const ClEvent& event) override {
    using Kind = ClEvent::Kind;
    switch (event.kind) {
      case Kind::Comment:
        return comment(event.text);
      case Kind::SpindleOn:
        return put(fmt::format("S{} {}", fmt::format("{:.0f}", event.value), event.choice < 0 ? "M4" : "M3"));
      case Kind::SpindleOff:
        return put("M5");
      case Kind::CoolantOn:
        return put(event.choice == 1 ? "M7" : "M8");
      case Kind::CoolantOff:
        return put("M9");
      case Kind::ToolChange:
        return put(fmt::format("T{:.0f} M6", event.value));
      case Kind::Stop:
        return put("M0");
      case Kind::OptionalStop:
        return put("M1");
      case Kind::Dwell:
        return dwell(event.value);
      case Kind::MachineCode:
        return put(fmt::format("M{:.0f}", event.value));
    }
  }

  void tipControl(int tool) override {
    motion_ = -1;
    put(options_.control == Control::Siemens ? "TRAORI" : fmt::format("G43.4 H{}", tool));
  }

  void rapid(const std::string& axes) override { put(code(0) + axes); }
  void line(const std::string& axes, const std::string& feed, FeedWriting writing) override {
    std::string mode;
    if (writing != writing_) mode = writing == FeedWriting::InverseTime ? "G93 " : "G94 ";
    writing_ = writing;
    put(mode + code(1) + axes + (feed.empty() ? "" : " F" + feed));
  }

  void end() override {
    if (writing_ == FeedWriting::InverseTime) put("G94");
    if (options_.tip_control) put(options_.control == Control::Siemens ? "TRAFOOF" : "G49");
    put(options_.control == Control::LinuxCnc ? "M2" : "M30");
    if (options_.control == Control::Fanuc) put("%");
  }

  std::string axisWord(int joint, double value) const override {
    const AxisId axis = machine_.joint(joint).axis;
    return axis.text() + (axis.digit != 0 ? "=" : "") + axisNumber(value, decimals(joint));
  }

 private:
  void put(const std::string& block) { text_ += block + "\n"; }
  void comment(const std::string& text) {
    const std::string clean = harmless(text, options_.control);
    put(options_.control == Control::Siemens ? "; " + clean : "(" + clean + ")");
  }
  void dwell(double seconds) {
    if (options_.control == Control::Siemens) return put("G4 F" + axisNumber(seconds, 3));
    if (options_.control == Control::LinuxCnc) return put("G4 P" + axisNumber(seconds, 3));
    put(fmt::format("G4 P{}", std::lround(seconds * 1000.0)));  // ms
  }
  /// "G0 ", "G1 " where it changes.
  std::string code(int motion) {
    if (motion == motion_) return "";
    motion_ = motion;
    return fmt::format("G{} ", motion);
  }
  std::string axisNames() const {
    std::string names;
    for (const kinematics::Joint& joint : machine_.joints())
      names += (names.empty() ? "" : ",") + joint.axis.text();
    return names;
  }
  int motion_ = -1;
  FeedWriting writing_ = FeedWriting::PerMinute;
};

}  // namespace

std::unique_ptr<ControlWriter> makeGCodeWriter(const Machine& machine, const NcOptions& options) {
  return std::make_unique<GCodeWriter>(machine, options);
}

}  // namespace nineline::postprocessing
