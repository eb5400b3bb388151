#pragma once

#include <memory>
#include <string>

#include "core/postprocessing/nc_words.h"

namespace nineline::postprocessing {

/// How the lines of one control look.
class ControlWriter {
 public:
  ControlWriter(const Machine& machine, const NcOptions& options) : machine_(machine), options_(options) {}
  virtual ~ControlWriter() = default;
  ControlWriter(const ControlWriter&) = delete;
  ControlWriter& operator=(const ControlWriter&) = delete;

  virtual void begin(const std::string& name) = 0;
  virtual void event(const ClEvent& event) = 0;
  /// Before the first motion, and after each tool change.
  virtual void tipControl(int tool) = 0;
  /// `axes`: the words that change, joined; `feed` empty in a rapid or where it stays.
  virtual void rapid(const std::string& axes) = 0;
  virtual void line(const std::string& axes, const std::string& feed, FeedWriting writing) = 0;
  virtual void end() = 0;
  [[nodiscard]] virtual std::string axisWord(int joint, double value) const = 0;

  [[nodiscard]] std::string take() { return std::move(text_); }
  [[nodiscard]] int decimals(int joint) const {
    return machine_.isRotary(joint) ? options_.rotary_decimals : options_.linear_decimals;
  }

 protected:
  const Machine& machine_;
  NcOptions options_;
  std::string text_;
};

/// Fanuc, Siemens and LinuxCNC.
[[nodiscard]] std::unique_ptr<ControlWriter> makeGCodeWriter(const Machine& machine,
                                                             const NcOptions& options);
/// Heidenhain Klartext.
[[nodiscard]] std::unique_ptr<ControlWriter> makeKlartextWriter(const Machine& machine,
                                                                const NcOptions& options);

}  // namespace nineline::postprocessing
