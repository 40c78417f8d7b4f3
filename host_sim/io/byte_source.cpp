#include "host_sim/io/byte_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include "host_sim/io/input_error.hpp"
#include "host_sim/io/interruption.hpp"
#include "host_sim/io/system_error_text.hpp"

namespace host_sim {
namespace {

class DescriptorSource final : public ByteSource {
 public:
  DescriptorSource(int descriptor, bool owned, std::string name, std::string_view accepted)
      : descriptor_(descriptor), owned_(owned), name_(std::move(name)), accepted_(accepted) {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) {
      const int error = errno;
      close();
      fail("cannot be read: " + reason_of(error));
    }
    if (S_ISDIR(status.st_mode)) {
      close();
      fail("is a directory");
    }
    blocks_ = !S_ISREG(status.st_mode);
    total_ = blocks_ ? 0 : static_cast<std::uint64_t>(status.st_size);
  }

  ~DescriptorSource() override { close(); }

  std::size_t read(std::span<char> buffer) override {
    for (;;) {
      if (blocks_) {
        wait_to_read(descriptor_);
      }
      const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
      if (count >= 0) {
        return static_cast<std::size_t>(count);
      }
      if (errno != EINTR) {
        fail("cannot be read: " + reason_of(errno));
      }
    }
  }

  std::uint64_t total() const noexcept override { return total_; }

 private:
  void close() noexcept {
    if (owned_) {
      ::close(descriptor_);
      owned_ = false;
    }
  }

  [[noreturn]] void fail(const std::string& found) const {
    throw InputError(name_, 0, 0, found, accepted_);
  }

  int descriptor_;
  bool owned_;
  bool blocks_ = false;
  std::string name_;
  std::string accepted_;
  std::uint64_t total_ = 0;
};

class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::string_view bytes) : rest_(bytes), total_(bytes.size()) {}

  std::size_t read(std::span<char> buffer) override {
    const std::size_t count = rest_.copy(buffer.data(), buffer.size());
    rest_.remove_prefix(count);
    return count;
  }

  std::uint64_t total() const noexcept override { return total_; }

 private:
  std::string_view rest_;
  std::uint64_t total_;
};

}  // namespace

std::unique_ptr<ByteSource> open_source(const std::filesystem::path& path,
                                        std::string_view accepted) {
  if (path == "-") {
    return std::make_unique<DescriptorSource>(STDIN_FILENO, false, "standard input", accepted);
  }
  // The first read waits for a writer of a FIFO.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    throw InputError(path.string(), 0, 0, "cannot be opened: " + reason_of(errno), accepted);
  }
  ::fcntl(descriptor, F_SETFL, 0);
  return std::make_unique<DescriptorSource>(descriptor, true, path.string(), accepted);
}

std::unique_ptr<ByteSource> memory_source(std::string_view bytes) {
  return std::make_unique<MemorySource>(bytes);
}

}  // namespace host_sim
