#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace nineline::nc {

/// The bytes of a program, line by line and with random access, in bounded memory.
class TextSource {
 public:
  struct Line {
    std::string_view text;      ///< without the line end; valid until the next call
    std::string_view line_end;  ///< "\n", "\r\n" or "" (end of file)
    std::uint64_t next = 0;     ///< offset of the following line
  };
  virtual ~TextSource() = default;
  [[nodiscard]] virtual const std::string& name() const = 0;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// The line that starts at `offset` < size(). A line longer than 1 MiB is a fault.
  [[nodiscard]] virtual Result<Line> lineAt(std::uint64_t offset) = 0;
};

/// A program held in memory.
class MemoryText final : public TextSource {
 public:
  MemoryText(std::string name, std::string bytes) : name_(std::move(name)), bytes_(std::move(bytes)) {}
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] Result<Line> lineAt(std::uint64_t offset) override;

 private:
  std::string name_;
  std::string bytes_;
};

/// A program in a file, read through a window of a few MiB.
[[nodiscard]] Result<std::unique_ptr<TextSource>> openTextFile(const std::filesystem::path& path);

}  // namespace nineline::nc
