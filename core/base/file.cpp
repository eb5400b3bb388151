#include "core/base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace nineline {

namespace fs = std::filesystem;

Result<std::string> readFile(const fs::path& path) {
  std::error_code fault;
  if (!fs::exists(path, fault)) return badInput("file.missing", "The file does not exist.", path.string());
  if (!fs::is_regular_file(path, fault)) return badInput("file.kind", "This is not a file.", path.string());
  std::ifstream in(path, std::ios::binary);
  if (!in)
    return badInput("file.open", fmt::format("The file cannot be opened: {}.", std::strerror(errno)),
                    path.string());
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) return badInput("file.read", "The file cannot be read to its end.", path.string());
  return bytes;
}

Result<void> writeFile(const fs::path& path, std::string_view bytes) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  if (Result<void> written = file->write(bytes); !written) return written;
  return file->commit();
}

AtomicFile::AtomicFile(fs::path target, fs::path temporary, std::FILE* stream)
    : target_(std::move(target)), temporary_(std::move(temporary)), stream_(stream) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      stream_(std::exchange(other.stream_, nullptr)) {}

AtomicFile::~AtomicFile() {
  if (stream_ == nullptr) return;
  std::fclose(stream_);
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

Result<AtomicFile> AtomicFile::create(const fs::path& target) {
  std::error_code fault;
  if (fs::is_directory(target, fault))
    return badInput("file.kind", "A folder stands where the file should be written.", target.string());
  if (fs::exists(target, fault) && !fs::is_regular_file(target, fault))  // renaming would replace a device
    return badInput("file.kind", "This is a device, not a file; nothing is written to it.", target.string());
  const fs::path resolved = fs::is_symlink(target, fault) ? fs::weakly_canonical(target, fault) : target;
  std::string pattern = resolved.string() + ".XXXXXX";
  const int descriptor = mkstemp(pattern.data());
  if (descriptor < 0)
    return badInput("file.create", fmt::format("The file cannot be created: {}.", std::strerror(errno)),
                    target.string());
  const mode_t mask = umask(0);
  umask(mask);
  struct stat old {};
  const mode_t mode = stat(resolved.c_str(), &old) == 0 ? old.st_mode & 07777 : 0666 & ~mask;
  static_cast<void>(fchmod(descriptor, mode));
  std::FILE* stream = fdopen(descriptor, "wb");
  std::setvbuf(stream, nullptr, _IOFBF, 1 << 18);
  return AtomicFile(resolved, pattern, stream);
}

Error AtomicFile::failure(const char* what) const {
  return badInput("file.write", fmt::format("{}: {}. The old file is untouched.", what, std::strerror(errno)),
                  target_.string());
}

Result<void> AtomicFile::write(std::string_view bytes) {
  NL_EXPECTS(stream_ != nullptr);
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size())
    return failure("The file cannot be written");
  return {};
}

Result<void> AtomicFile::flush() {
  NL_EXPECTS(stream_ != nullptr);
  if (std::fflush(stream_) != 0) return failure("The file cannot be written");
  return {};
}

Result<void> AtomicFile::commit() {
  if (Result<void> flushed = flush(); !flushed) return flushed;
  if (fsync(fileno(stream_)) != 0 && errno != EINVAL && errno != EROFS)
    return failure("The file cannot be written to the disk");
  if (std::fclose(std::exchange(stream_, nullptr)) != 0 ||
      std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    const Error error = failure("The file cannot be put in place");
    std::error_code ignored;
    fs::remove(temporary_, ignored);
    return error;
  }
  return {};
}

}  // namespace nineline
