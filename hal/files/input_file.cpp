#include "hal/files/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"

namespace hal::files {
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

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

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

std::string read_text_file(const std::filesystem::path& path, std::string_view accepted,
                           std::size_t most_bytes) {
  const auto source = open_source(path, accepted);
  std::string text(most_bytes + 1, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const std::size_t count = source->read({text.data() + size, text.size() - size});
    if (count == 0) {
      text.resize(size);
      return text;
    }
    size += count;
  }
  throw InputError(path.string(), 0, 0,
                   most_bytes == kMostTextBytes ? "larger than 1 MiB"
                                                : fmt::format("larger than {} bytes", most_bytes),
                   accepted);
}

std::string file_name(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path.string();
}

LineBuffer::LineBuffer(std::unique_ptr<ByteSource> source, std::string name, std::size_t window)
    : source_(std::move(source)),
      name_(std::move(name)),
      buffer_(window + 1 + kSpare),
      position_(buffer_.data()),
      lines_end_(position_),
      data_end_(buffer_.data()) {
  if (refill()) {
    skip_byte_order_mark();
  }
}

const char* LineBuffer::line_end() const noexcept {
  const auto size = static_cast<std::size_t>(lines_end_ - position_);
  return static_cast<const char*>(std::memchr(position_, '\n', size));
}

std::string_view LineBuffer::line() const noexcept {
  const char* end = line_end();
  if (end != position_ && end[-1] == '\r') {
    --end;
  }
  return {position_, static_cast<std::size_t>(end - position_)};
}

std::uint64_t LineBuffer::bytes_read() const noexcept {
  const auto in_buffer = static_cast<std::uint64_t>(position_ - buffer_.data());
  return std::min(bytes_before_buffer_ + in_buffer, bytes_from_source_);
}

bool LineBuffer::refill() {
  char* const front = buffer_.data();
  const auto kept = static_cast<std::size_t>(data_end_ - position_);
  bytes_before_buffer_ += static_cast<std::uint64_t>(position_ - front);
  std::memmove(front, position_, kept);
  position_ = front;
  lines_end_ = front;
  data_end_ = front + kept;
  for (;;) {
    const auto used = static_cast<std::size_t>(data_end_ - buffer_.data());
    if (used == room()) {
      grow();
    }
    const std::size_t count = source_->read({data_end_, room() - used});
    if (count == 0) {
      if (used != 0) {
        *data_end_++ = '\n';
      }
      lines_end_ = data_end_;
      return used != 0;
    }
    bytes_from_source_ += count;
    const std::size_t last = std::string_view(data_end_, count).rfind('\n');
    if (last != std::string_view::npos) {
      lines_end_ = data_end_ + last + 1;
      data_end_ += count;
      return true;
    }
    data_end_ += count;
  }
}

std::string_view LineBuffer::hand_over(std::vector<char>& memory) {
  const auto first = static_cast<std::size_t>(position_ - buffer_.data());
  const auto size = static_cast<std::size_t>(lines_end_ - position_);
  const auto kept = static_cast<std::size_t>(data_end_ - lines_end_);
  bytes_before_buffer_ += first + size;
  memory.resize(buffer_.size());
  std::memcpy(memory.data(), lines_end_, kept);
  buffer_.swap(memory);
  position_ = buffer_.data();
  lines_end_ = position_;
  data_end_ = buffer_.data() + kept;
  return {memory.data() + first, size};
}

// A line fills the buffer.
void LineBuffer::grow() {
  const std::size_t used = room();
  if (used == kLineLimit) {
    throw InputError(name_, line_number_, 0, "a line that does not end", "lines of at most 1 MiB");
  }
  buffer_.resize(2 * used + 1 + kSpare);
  position_ = buffer_.data();
  lines_end_ = position_;
  data_end_ = buffer_.data() + used;
}

void LineBuffer::skip_byte_order_mark() {
  if (line().starts_with(kByteOrderMark)) {
    position_ += kByteOrderMark.size();
  }
}

}  // namespace hal::files
