#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace nineline {

/// The bytes of a file. Fails with BadInput and the system's reason; a folder or a device is refused.
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path);

/// Writes the bytes beside the target and renames: the old file stays untouched on any failure.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

/// A file that appears whole or not at all: written beside its target, renamed by `commit`, deleted
/// otherwise.
class AtomicFile {
 public:
  [[nodiscard]] static Result<AtomicFile> create(const std::filesystem::path& target);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  /// Buffered. A full disk is reported here or by `commit`.
  [[nodiscard]] Result<void> write(std::string_view bytes);
  /// Flushes to the disk and replaces the target.
  [[nodiscard]] Result<void> commit();
  /// Where the bytes lie until `commit`; what was written is visible there after `flush`.
  [[nodiscard]] const std::filesystem::path& temporaryPath() const { return temporary_; }
  [[nodiscard]] Result<void> flush();

 private:
  AtomicFile(std::filesystem::path target, std::filesystem::path temporary, std::FILE* stream);
  [[nodiscard]] Error failure(const char* what) const;
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::FILE* stream_ = nullptr;
};

}  // namespace nineline
