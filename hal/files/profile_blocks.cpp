#include "hal/files/profile_blocks.hpp"

#include <cstring>
#include <utility>

#include "hal/files/input_error.hpp"

namespace hal::files {
namespace {

/// Blocks of a thread that are read before their rows can be taken.
constexpr std::size_t kBlocksAhead = 2;

}  // namespace

ProfileBlocks::ProfileBlocks(LineBuffer& lines, std::string_view name, ProfileLayout layout,
                             const ProfileRowColumns& row_columns, unsigned threads)
    : lines_(lines),
      name_(name),
      parser_(std::move(layout)),
      row_columns_(row_columns),
      blocks_(threads == 1 ? 1 : kBlocksAhead * threads),
      line_number_(lines.line_number()) {
  for (unsigned i = 1; i < threads; ++i) {
    helpers_.emplace_back([this](const std::stop_token& stop) { help(stop); });
  }
}

std::span<const ProfileRow> ProfileBlocks::next() {
  for (;;) {
    read_ahead();
    if (taken_ == read_) {
      return {};
    }
    Block& block = parsed_block();
    finish(block);
    ++taken_;
    if (!block.rows.empty()) {
      return block.rows;
    }
  }
}

void ProfileBlocks::help(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return claimed_ != read_; })) {
    parse_next(lock);
  }
}

void ProfileBlocks::parse_next(std::unique_lock<std::mutex>& lock) {
  Block& block = block_of(claimed_++);
  lock.unlock();
  parse(block, -std::numeric_limits<double>::infinity());
  lock.lock();
  block.parsed = true;
  changed_.notify_all();
}

void ProfileBlocks::parse(Block& block, double last_time_s) const {
  ProfileRowParser::Values values{};
  const char* at = block.at;
  while (at != block.end) {
    const char* line_end = nullptr;
    if (*at == '#') {
      const auto size = static_cast<std::size_t>(block.end - at);
      line_end = static_cast<const char*>(std::memchr(at, '\n', size));
      if (std::memchr(at, '\0', static_cast<std::size_t>(line_end - at)) != nullptr) {
        break;
      }
    } else {
      line_end = parser_.plain(at, block.end, last_time_s, values);
      if (line_end == nullptr) {
        break;
      }
      block.rows.push_back(row_of(values, block.lines));
      last_time_s = values[kTime];
    }
    at = line_end + 1;
    ++block.lines;
  }
  block.at = at;
}

ProfileRow ProfileBlocks::row_of(const ProfileRowParser::Values& values, std::uint64_t line) const {
  return {values[kTime],
          values[row_columns_.value],
          values[kTendonVelocity],
          values[row_columns_.bend],
          values[kMotorAngle],
          values[kSheathTemperature],
          values[kWindingTemperature],
          line};
}

void ProfileBlocks::read_ahead() {
  if (taken_ == read_) {
    reading_failed_ = false;
    lines_.set_line_number(line_number_);
  }
  while (!ended_ && !reading_failed_ && read_ < taken_ + blocks_.size()) {
    try {
      if (!lines_.fill()) {
        ended_ = true;
        return;
      }
    } catch (...) {
      if (taken_ == read_) {
        throw;
      }
      reading_failed_ = true;
      return;
    }
    read(block_of(read_));
    const std::lock_guard lock(mutex_);
    ++read_;
    changed_.notify_all();
  }
}

void ProfileBlocks::read(Block& block) {
  const std::string_view text = lines_.hand_over(block.memory);
  block.front = text.data();
  block.at = block.front;
  block.end = block.front + text.size();
  block.lines = 0;
  block.bytes_read = lines_.bytes_read();
  block.rows.clear();
  // A field that is not passed over has a character and a delimiter at least, so that threads need
  // no more.
  block.rows.reserve(block.memory.size() / (2 * parser_.layout().channels.count()) + 1);
  block.parsed = false;
}

ProfileBlocks::Block& ProfileBlocks::parsed_block() {
  Block& block = block_of(taken_);
  std::unique_lock lock(mutex_);
  while (!block.parsed) {
    if (claimed_ != read_) {
      parse_next(lock);
    } else {
      changed_.wait(lock, [&] { return block.parsed; });
    }
  }
  return block;
}

void ProfileBlocks::finish(Block& block) {
  if (!block.rows.empty() && !(block.rows.front().time_s > last_time_s_)) {
    block.rows.clear();
    block.at = block.front;
    block.lines = 0;
    parse(block, last_time_s_);
  }
  while (block.at != block.end) {
    take_odd_line(block);
    parse(block, block.rows.empty() ? last_time_s_ : block.rows.back().time_s);
  }
  for (ProfileRow& row : block.rows) {
    row.line += line_number_;
  }
  if (!block.rows.empty()) {
    last_time_s_ = block.rows.back().time_s;
  }
  line_number_ += block.lines;
  bytes_read_ = block.bytes_read;
}

void ProfileBlocks::take_odd_line(Block& block) {
  const auto size = static_cast<std::size_t>(block.end - block.at);
  const char* const line_end = static_cast<const char*>(std::memchr(block.at, '\n', size));
  std::string_view text(block.at, static_cast<std::size_t>(line_end - block.at));
  if (text.ends_with('\r')) {
    text.remove_suffix(1);
  }
  const TextPlace line{name_, line_number_ + block.lines, text};
  if (text.starts_with('#')) {
    refuse_nul(line);
  } else {
    ProfileRowParser::Values values{};
    parser_.by_the_book(line, block.rows.empty() ? last_time_s_ : block.rows.back().time_s, values);
    block.rows.push_back(row_of(values, block.lines));
  }
  block.at = line_end + 1;
  ++block.lines;
}

}  // namespace hal::files
