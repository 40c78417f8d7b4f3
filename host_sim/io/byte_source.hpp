#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace host_sim {

/// Where bytes come from, read once from the front to the back.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Fills the front of `buffer` and returns how many bytes; fewer than asked for is not the end,
  /// 0 is. Throws InputError if reading fails.
  virtual std::size_t read(std::span<char> buffer) = 0;

  /// The size in bytes, 0 if it is not known beforehand.
  virtual std::uint64_t total() const noexcept { return 0; }
};

/// A file, pipe or device; `-` is standard input. Throws InputError if it is missing, unreadable or
/// a directory; `accepted` says in that error what is accepted.
std::unique_ptr<ByteSource> open_source(const std::filesystem::path& path,
                                        std::string_view accepted);

/// Bytes in memory, which must outlive the source.
std::unique_ptr<ByteSource> memory_source(std::string_view bytes);

}  // namespace host_sim
