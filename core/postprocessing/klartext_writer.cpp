#include <fmt/format.h>

#include <algorithm>

#include "core/postprocessing/control_writer.h"

namespace nineline::postprocessing {

namespace {

class KlartextWriter final : public ControlWriter {
 public:
  using ControlWriter::ControlWriter;

  void begin(const std::string& name) override {
    for (const char c : harmless(name, options_.control)) {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0) name_ += c;
    }
    name_ = name_.empty() ? "POST" : name_.substr(0, 16);
    put("BEGIN PGM " + name_ + " MM");
  }

  void event(const ClEvent& event) override {
    using Kind = ClEvent::Kind;
    switch (event.kind) {
      case Kind::Comment:
        return put("; " + harmless(event.text, options_.control));
      case Kind::SpindleOn:
        put(fmt::format("TOOL CALL S{:.0f}", event.value));
        return put(event.choice < 0 ? "L M4" : "L M3");
      case Kind::SpindleOff:
        return put("L M5");
      case Kind::CoolantOn:
        return put(event.choice == 1 ? "L M7" : "L M8");
      case Kind::CoolantOff:
        return put("L M9");
      case Kind::ToolChange:
        if (tip_control_) put("L M129");
        tip_control_ = false;
        return put(fmt::format("TOOL CALL {:.0f} Z", event.value));
      case Kind::Stop:
        return put("L M0");
      case Kind::OptionalStop:
        return put("L M1");
      case Kind::Dwell:
        put("CYCL DEF 9.0 DWELL TIME");
        return put("CYCL DEF 9.1 DWELL " + axisNumber(event.value, 3));
      case Kind::MachineCode:
        return put(fmt::format("L M{:.0f}", event.value));
    }
  }

  void tipControl(int) override {
    tip_control_ = true;
    put("L M128");
  }
  void rapid(const std::string& axes) override { put("L " + axes + " R0 FMAX"); }
  void line(const std::string& axes, const std::string& feed, FeedWriting) override {
    const std::string number = feed.ends_with('.') ? feed.substr(0, feed.size() - 1) : feed;
    put("L " + axes + (feed.empty() ? "" : " F" + number));
  }
  void end() override {
    if (tip_control_) put("L M129");
    put("L M30");
    put("END PGM " + name_ + " MM");
  }

  std::string axisWord(int joint, double value) const override {
    std::string number = axisNumber(value, decimals(joint));
    if (number.ends_with('.')) number.pop_back();
    return machine_.joint(joint).axis.text() + (number.starts_with('-') ? "" : "+") + number;
  }

 private:
  void put(const std::string& block) { text_ += fmt::format("{} {}\n", number_++, block); }
  std::size_t number_ = 0;
  std::string name_;
  bool tip_control_ = false;
};

}  // namespace

std::unique_ptr<ControlWriter> makeKlartextWriter(const Machine& machine, const NcOptions& options) {
  return std::make_unique<KlartextWriter>(machine, options);
}

}  // namespace nineline::postprocessing
