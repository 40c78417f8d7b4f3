#include "hal/files/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstdio>
#include <functional>
#include <optional>
#include <streambuf>
#include <system_error>
#include <utility>

#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "hal/files/text.hpp"

namespace hal::files {
namespace {

namespace fs = std::filesystem;

class DescriptorBuffer final : public std::streambuf {
 public:
  DescriptorBuffer(int descriptor, std::string path)
      : descriptor_(descriptor), path_(std::move(path)) {
    struct stat status {};
    blocks_ = ::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode);
    setp(bytes_.data(), bytes_.data() + bytes_.size());
  }

 protected:
  int_type overflow(int_type c) override {
    flush();
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      *pptr() = traits_type::to_char_type(c);
      pbump(1);
    }
    return traits_type::not_eof(c);
  }

  int sync() override {
    flush();
    return 0;
  }

 private:
  void flush() {
    const char* at = pbase();
    while (at != pptr()) {
      auto most = static_cast<std::size_t>(pptr() - at);
      if (blocks_) {
        wait_to_write(descriptor_);
        most = std::min<std::size_t>(most, PIPE_BUF);
      }
      const ssize_t count = ::write(descriptor_, at, most);
      if (count >= 0) {
        at += count;
      } else if (errno != EINTR) {
        throw OutputError(path_, reason_of(errno));
      }
    }
    setp(bytes_.data(), bytes_.data() + bytes_.size());
  }

  int descriptor_;
  std::string path_;
  bool blocks_;
  std::array<char, 65536> bytes_{};
};

/// Where the bytes go, and the rename that is left to do.
struct Destination {
  int descriptor;
  bool owned;
  fs::path partial;  ///< empty if written directly
  fs::path target;
};

Destination open_directly(const fs::path& path, bool fifo) {
  constexpr std::chrono::milliseconds kUntilAReaderComes{20};
  int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
  while (descriptor < 0 && errno == ENXIO && fifo) {
    wait_for(kUntilAReaderComes);
    descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
  }
  if (descriptor < 0) {
    throw OutputError(path.string(), reason_of(errno));
  }
  ::fcntl(descriptor, F_SETFL, 0);
  return {descriptor, true, {}, path};
}

// The lock distinguishes a file that is being written from one left over by a process that was
// killed.
int open_partial(const fs::path& partial, const fs::path& path) {
  const int descriptor = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    throw OutputError(path.string(), reason_of(errno));
  }
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    ::close(descriptor);
    throw OutputError(path.string(), "it is being written already");
  }
  if (::ftruncate(descriptor, 0) != 0) {
    const int error = errno;
    ::close(descriptor);
    throw OutputError(path.string(), reason_of(error));
  }
  return descriptor;
}

Destination open_destination(const fs::path& path) {
  if (path == "-") {
    return {STDOUT_FILENO, false, {}, path};
  }
  if (!path.has_filename()) {
    throw OutputError(path.string(), "it names no file");
  }
  if (const std::size_t bytes = path.filename().native().size(); bytes > NAME_MAX) {
    throw OutputError(path.string(),
                      fmt::format("its name has {} bytes; accepted: {} at most", bytes, NAME_MAX));
  }
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    throw OutputError(path.string(), reason_of(EISDIR));
  }
  if (exists && !S_ISREG(status.st_mode)) {
    return open_directly(path, S_ISFIFO(status.st_mode));
  }
  std::error_code failure;
  const fs::path target = exists ? fs::canonical(path, failure) : path;
  if (failure) {
    throw OutputError(path.string(), failure.message());
  }
  if (exists && ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
    throw OutputError(path.string(), reason_of(errno));
  }
  fs::path partial = partial_of(target);
  const int descriptor = open_partial(partial, path);
  if (exists) {
    static_cast<void>(::fchmod(descriptor, status.st_mode & 07777));
  }
  return {descriptor, true, std::move(partial), target};
}

}  // namespace

OutputError::OutputError(std::string_view path, std::string_view reason)
    : std::runtime_error(
          fmt::format("{}: cannot be written: {}", printable(path), printable(reason))),
      path_(printable(path)),
      reason_(printable(reason)) {}

fs::path partial_of(const fs::path& path) {
  std::string name = path.filename().string();
  std::string end = fmt::format(".partial-{}", ::getpid());
  if (name.size() + end.size() > NAME_MAX) {
    end = fmt::format(".{:x}{}", std::hash<std::string>()(name), end);
    name.resize(NAME_MAX - end.size());
  }
  return path.parent_path() / (name + end);
}

void sync_folder_of(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) {
    return;  // a folder may be written without being read
  }
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  // Some file systems have no such call for a folder.
  if (error != 0 && error != EINVAL && error != ENOTSUP) {
    throw OutputError(path.string(), reason_of(error));
  }
}

class OutputFile::Impl {
 public:
  explicit Impl(const fs::path& path)
      : name_(path == "-" ? "standard output" : path.string()),
        destination_(open_destination(path)),
        buffer_(destination_.descriptor, name_),
        stream_(&buffer_) {
    stream_.exceptions(std::ios::badbit | std::ios::failbit);
  }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  ~Impl() {
    if (!destination_.partial.empty()) {
      ::unlink(destination_.partial.c_str());
    }
    if (destination_.owned) {
      ::close(destination_.descriptor);
    }
  }

  std::ostream& stream() noexcept { return stream_; }

  void commit() {
    stream_.flush();
    if (!destination_.partial.empty()) {
      if (::fsync(destination_.descriptor) != 0 ||
          ::rename(destination_.partial.c_str(), destination_.target.c_str()) != 0) {
        throw OutputError(name_, reason_of(errno));
      }
      destination_.partial.clear();
      sync_folder_of(destination_.target);
    }
    if (std::exchange(destination_.owned, false) && ::close(destination_.descriptor) != 0) {
      throw OutputError(name_, reason_of(errno));
    }
  }

 private:
  std::string name_;
  Destination destination_;
  DescriptorBuffer buffer_;
  std::ostream stream_;
};

OutputFile::OutputFile(const fs::path& path) : impl_(std::make_unique<Impl>(path)) {}
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;
OutputFile::~OutputFile() = default;

void OutputFile::write(std::string_view text) {
  stream().write(text.data(), static_cast<std::streamsize>(text.size()));
}

std::ostream& OutputFile::stream() noexcept {
  return impl_->stream();
}

void OutputFile::commit() {
  impl_->commit();
}

void write_file(const fs::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace hal::files
