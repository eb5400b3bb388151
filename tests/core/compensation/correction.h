#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/compensation/compensation.h"
#include "core/errors/error_model_file.h"

namespace nineline::test_support {

/// A model from a built-in machine's id and the entries of its `effects`.
inline errors::ErrorModel modelFrom(const std::string& machine, const std::string& effects) {
  const Result<errors::ErrorModel> model = errors::readErrorModel(
      R"({"format": "nineline-model/1", "machine": ")" + machine + R"(", "effects": [)" + effects + "]}",
      "test");
  EXPECT_TRUE(model) << model.error().message();
  return model.value();
}

/// k µm/m on a joint's own positioning.
inline std::string scale(const std::string& joint, double k) {
  return R"({"effect": "scale", "joint": ")" + joint + R"(", "component": "E)" + joint + joint +
         R"(", "parameters": {"k": {"value": )" + std::to_string(k) + R"(, "unit": "um/m"}}})";
}

inline std::string backlash(const std::string& joint, double width_um) {
  return R"({"effect": "backlash", "joint": ")" + joint + R"(", "component": "E)" + joint + joint +
         R"(", "parameters": {"width": {"value": )" + std::to_string(width_um) + R"(, "unit": "um"}}})";
}

/// X turned by 1e-4 rad about Z. On generic-3axis, whose table carries X on Y, that makes the tool in W stand
/// at (x + y sin θ, y cos θ, z): commands for (X, Y) are (X − Y tan θ, Y / cos θ).
inline std::string squareX() {
  return R"({"effect": "location", "component": "C0X", "value_arcsec": 20.626480624709636})";
}
constexpr double kSquareness = 1e-4;  // rad

inline Result<compensation::CompensatedText> correct(const errors::ErrorModel& model, const std::string& text,
                                                     const compensation::CompensationOptions& options = {},
                                                     const simulation::ProgramSetup& setup = {}) {
  NoProgress progress;
  return compensation::compensateText(model, "test.nc", text, setup, options, progress);
}

/// The corrected text; the error's message where there is none.
inline std::string corrected(const errors::ErrorModel& model, const std::string& text,
                             const compensation::CompensationOptions& options = {},
                             const simulation::ProgramSetup& setup = {}) {
  const Result<compensation::CompensatedText> result = correct(model, text, options, setup);
  return result ? result->text : result.error().message();
}

inline std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

inline bool hasWarning(const compensation::CompensationReport& report, const std::string& code) {
  for (const Diagnostic& one : report.diagnostics.all()) {
    if (one.code == code) return true;
  }
  return false;
}

}  // namespace nineline::test_support
