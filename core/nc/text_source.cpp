#include "core/nc/text_source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20;
constexpr std::size_t kWindow = std::size_t{4} << 20;

/// The line at the start of `bytes`; a CR LF, a LF and a CR alone end it. `complete` says that the file ends
/// with `bytes`. Nothing where no line end is in sight.
bool splitLine(std::string_view bytes, bool complete, std::uint64_t offset, TextSource::Line& line) {
  const void* const found = std::memchr(bytes.data(), '\n', bytes.size());
  std::size_t size =
      found ? static_cast<std::size_t>(static_cast<const char*>(found) - bytes.data()) : bytes.size();
  if (const void* const cr = std::memchr(bytes.data(), '\r', size)) {
    const auto before = static_cast<std::size_t>(static_cast<const char*>(cr) - bytes.data());
    const bool at_end = before + 1 == size;
    if (!found && at_end && !complete) return false;
    const bool pair = found && at_end;
    line = {bytes.substr(0, before), bytes.substr(before, pair ? 2 : 1), offset + before + (pair ? 2 : 1)};
    return true;
  }
  if (!found && !complete) return false;
  line = {bytes.substr(0, size), bytes.substr(size, found ? 1 : 0), offset + size + (found ? 1 : 0)};
  return true;
}

Error tooLong(const std::string& name) {
  return badInput(code::kLineTooLong, "A line of the program is longer than 1 MiB; it is no NC program",
                  name);
}

class FileText final : public TextSource {
 public:
  FileText(std::string name, int file, std::uint64_t size)
      : name_(std::move(name)), file_(file), size_(size) {}
  ~FileText() override { ::close(file_); }
  FileText(const FileText&) = delete;
  FileText& operator=(const FileText&) = delete;

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::uint64_t size() const override { return size_; }

  [[nodiscard]] Result<Line> lineAt(std::uint64_t offset) override {
    NL_EXPECTS(offset < size_, offset, size_);
    Line line;
    for (bool loaded = false;; loaded = true) {
      if (offset >= begin_ && offset < begin_ + used_) {
        const std::string_view bytes(window_.data() + (offset - begin_),
                                     static_cast<std::size_t>(begin_ + used_ - offset));
        const bool complete = begin_ + used_ == size_;
        if (splitLine(bytes, complete, offset, line)) {
          if (line.text.size() > kLongestLine) return tooLong(name_);
          return line;
        }
        if (loaded) return tooLong(name_);
      }
      if (Result<void> done = load(offset); !done) return done.error();
    }
  }

 private:
  Result<void> load(std::uint64_t offset) {
    window_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kWindow, size_)));
    begin_ = offset;
    used_ = 0;
    while (used_ < window_.size() && begin_ + used_ < size_) {
      const ssize_t got =
          ::pread(file_, window_.data() + used_, window_.size() - used_, static_cast<off_t>(begin_ + used_));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) {
        const char* const why = got == 0 ? "it became shorter while it was read" : std::strerror(errno);
        return badInput(code::kUnreadable, fmt::format("The program cannot be read: {}", why), name_);
      }
      used_ += static_cast<std::size_t>(got);
    }
    return {};
  }

  std::string name_;
  int file_;
  std::uint64_t size_;
  std::vector<char> window_;
  std::uint64_t begin_ = 0;
  std::size_t used_ = 0;
};

}  // namespace

Result<TextSource::Line> MemoryText::lineAt(std::uint64_t offset) {
  NL_EXPECTS(offset < bytes_.size(), offset, bytes_.size());
  Line line;
  splitLine(std::string_view(bytes_).substr(static_cast<std::size_t>(offset)), true, offset, line);
  if (line.text.size() > kLongestLine) return tooLong(name_);
  return line;
}

Result<std::unique_ptr<TextSource>> openTextFile(const std::filesystem::path& path) {
  const std::string name = path.string();
  const int file = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) {
    return badInput(code::kUnreadable, fmt::format("The program cannot be opened: {}", std::strerror(errno)),
                    name);
  }
  struct stat status {};
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(file);
    return badInput(code::kUnreadable, "The program cannot be opened: it is no regular file", name);
  }
  return std::unique_ptr<TextSource>(
      std::make_unique<FileText>(name, file, static_cast<std::uint64_t>(status.st_size)));
}

}  // namespace nineline::nc
