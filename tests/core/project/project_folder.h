#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "core/project/project_file.h"

namespace nineline::project {

/// A folder of its own for each test, gone afterwards, and a project in it.
class ProjectFolder : public ::testing::Test {
 protected:
  ProjectFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "nineline-project-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~ProjectFolder() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path path(const std::string& name = "case.nineline") const {
    return folder_ / name;
  }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()));
  }
  /// The value, or a failed test that says why there is none.
  template <typename T>
  static T good(Result<T> result) {
    if (result) return *std::move(result);
    throw std::runtime_error(result.error().code + ": " + result.error().message());
  }
  static void good(const Result<void>& result) {
    if (!result) throw std::runtime_error(result.error().code + ": " + result.error().message());
  }

  std::filesystem::path folder_;
};

}  // namespace nineline::project
