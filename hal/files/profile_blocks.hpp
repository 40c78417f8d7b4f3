#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "hal/files/input_file.hpp"
#include "hal/files/profile.hpp"
#include "hal/files/profile_rows.hpp"

namespace hal::files {

/// Where the values of a row go.
struct ProfileRowColumns {
  unsigned value = kProfileColumnCount;  ///< a ProfileColumnId, or this: 0
  unsigned bend = kProfileColumnCount;   ///< the same
};

/// Goes through the rows of a profile block by block, in constant memory. Several threads parse
/// blocks that have been read ahead; rows and errors are those of one after the other.
///
/// A thread parses a block as if it were the first, and stops at the first row that is none of the
/// common ones. The caller, in order, looks whether time goes on from the block before, and takes
/// what a block stopped at by the book.
class ProfileBlocks {
 public:
  /// What is read at once, in bytes.
  static constexpr std::size_t kWindow = std::size_t{1} << 17;
  /// Of threads: more would wait for the caller.
  static constexpr unsigned kMostThreads = 4;

  /// @param lines up to the first row; outlives this object
  /// @param name stands for the file in errors
  /// @param threads at least 1, the caller among them; more only where reading does not wait for
  /// somebody
  ProfileBlocks(LineBuffer& lines, std::string_view name, ProfileLayout layout,
                const ProfileRowColumns& row_columns, unsigned threads);

  /// The next rows, none at the end; they stay until the next call. Throws InputError for what is
  /// no profile; after an error the object is of no further use.
  std::span<const ProfileRow> next();

  /// Bytes of the source up to the end of the block.
  std::uint64_t bytes_read() const noexcept { return bytes_read_; }

 private:
  /// Lines of the file, and what they hold.
  struct Block {
    std::vector<char> memory;
    const char* front = nullptr;
    const char* at = nullptr;  ///< up to here they are parsed
    const char* end = nullptr;
    std::uint64_t lines = 0;  ///< before `at`
    std::uint64_t bytes_read = 0;
    std::vector<ProfileRow> rows;  ///< lines counted from 0
    bool parsed = false;
  };

  void help(const std::stop_token& stop);
  void parse_next(std::unique_lock<std::mutex>& lock);
  /// Up to its end, or to a row that is none of the common ones.
  void parse(Block& block, double last_time_s) const;
  ProfileRow row_of(const ProfileRowParser::Values& values, std::uint64_t line) const;

  void read_ahead();
  void read(Block& block);
  /// Waits for the next block, or parses it.
  Block& parsed_block();
  /// What threads have left to be done in order.
  void finish(Block& block);
  void take_odd_line(Block& block);

  Block& block_of(std::uint64_t number) {
    return blocks_[static_cast<std::size_t>(number % blocks_.size())];
  }

  LineBuffer& lines_;
  std::string name_;
  ProfileRowParser parser_;
  ProfileRowColumns row_columns_;
  std::vector<Block> blocks_;
  // Numbers of blocks, each the next.
  std::uint64_t taken_ = 0;
  std::uint64_t read_ = 0;
  std::uint64_t claimed_ = 0;  ///< by a thread that parses it
  bool ended_ = false;
  bool reading_failed_ = false;  ///< ahead; tried again once all before it has been taken
  std::uint64_t line_number_;    ///< of the next block
  double last_time_s_ = -std::numeric_limits<double>::infinity();
  std::uint64_t bytes_read_ = 0;
  std::mutex mutex_;  ///< of `read_`, `claimed_` and Block::parsed
  std::condition_variable_any changed_;
  std::vector<std::jthread> helpers_;
};

}  // namespace hal::files
