#include "host_sim/io/line_buffer.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "host_sim/io/input_error.hpp"

namespace host_sim {
namespace {

constexpr std::size_t kUsualSize = std::size_t{1} << 16;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

LineBuffer::LineBuffer(std::unique_ptr<ByteSource> source, std::string name)
    : source_(std::move(source)),
      name_(std::move(name)),
      buffer_(kUsualSize + 1),
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
    if (used == buffer_.size() - 1) {
      grow();
    }
    const std::size_t count = source_->read({data_end_, buffer_.size() - 1 - used});
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

// A line fills the buffer.
void LineBuffer::grow() {
  const std::size_t used = buffer_.size() - 1;
  if (used == kLineLimit) {
    throw InputError(name_, line_number_, 0, "a line that does not end", "lines of at most 1 MiB");
  }
  buffer_.resize(2 * used + 1);
  position_ = buffer_.data();
  lines_end_ = position_;
  data_end_ = buffer_.data() + used;
}

void LineBuffer::skip_byte_order_mark() {
  if (line().starts_with(kByteOrderMark)) {
    position_ += kByteOrderMark.size();
  }
}

}  // namespace host_sim
