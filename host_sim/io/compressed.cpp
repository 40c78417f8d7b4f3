#include "host_sim/io/compressed.hpp"

#include <fmt/format.h>
#include <zlib.h>
#ifdef TENDONLIFE_ZSTD
#include <zstd.h>
#include <zstd_errors.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"

namespace host_sim {

using hal::files::ByteSource;
using hal::files::InputError;

namespace {

constexpr std::string_view kGzip = "\x1F\x8B";
constexpr std::string_view kZstd = "\x28\xB5\x2F\xFD";
constexpr std::size_t kChunk = std::size_t{1} << 16;

/// The bytes of a compressed source, a chunk at a time.
class Chunks {
 public:
  Chunks(std::unique_ptr<ByteSource> source, std::string name, std::string_view format,
         std::string_view front)
      : source_(std::move(source)), name_(std::move(name)), format_(format), memory_(kChunk) {
    front.copy(memory_.data(), front.size());
    rest_ = std::span(memory_).first(front.size());
  }

  /// What has not been taken yet; read anew where that is nothing, and empty at the end.
  std::span<char> rest() {
    if (rest_.empty()) {
      rest_ = std::span(memory_).first(source_->read(memory_));
    }
    return rest_;
  }
  void take(std::size_t count) { rest_ = rest_.subspan(count); }

  [[noreturn]] void fail(std::string_view what) const {
    throw InputError(name_, 0, 0, fmt::format("its {} data {}", format_, what),
                     fmt::format("a whole file of {}", format_));
  }

 private:
  std::unique_ptr<ByteSource> source_;
  std::string name_;
  std::string_view format_;
  std::vector<char> memory_;
  std::span<char> rest_;
};

/// A file of gzip: members (RFC 1952), one behind the other.
class GzipSource final : public ByteSource {
 public:
  explicit GzipSource(Chunks chunks) : chunks_(std::move(chunks)) {
    constexpr int kGzipAlone = 16;
    if (::inflateInit2(&stream_, MAX_WBITS + kGzipAlone) != Z_OK) {
      throw std::bad_alloc();
    }
  }
  ~GzipSource() override { ::inflateEnd(&stream_); }

  std::size_t read(std::span<char> buffer) override {
    while (!buffer.empty()) {
      const std::span<char> in = chunks_.rest();
      // What has been taken may have more bytes in it than there was room for.
      if (in.empty() && !(in_member_ && full_)) {
        if (in_member_) {
          chunks_.fail("end too early");
        }
        return 0;
      }
      stream_.next_in = reinterpret_cast<Bytef*>(in.data());
      stream_.avail_in = static_cast<uInt>(in.size());
      stream_.next_out = reinterpret_cast<Bytef*>(buffer.data());
      const auto room = static_cast<uInt>(std::min(buffer.size(), kChunk));
      stream_.avail_out = room;
      in_member_ = true;
      const int result = ::inflate(&stream_, Z_NO_FLUSH);
      chunks_.take(in.size() - stream_.avail_in);
      if (result == Z_STREAM_END) {
        in_member_ = false;
        ::inflateReset(&stream_);
      } else if (result != Z_OK && result != Z_BUF_ERROR) {
        chunks_.fail("are damaged");
      }
      full_ = stream_.avail_out == 0;
      if (stream_.avail_out != room) {
        return room - stream_.avail_out;
      }
    }
    return 0;
  }

 private:
  Chunks chunks_;
  z_stream stream_{};
  bool in_member_ = false;
  bool full_ = false;
};

#ifdef TENDONLIFE_ZSTD
/// Frames of zstd (RFC 8878), one behind the other.
class ZstdSource final : public ByteSource {
  static constexpr std::size_t kLongestHeader = 18;

 public:
  explicit ZstdSource(Chunks chunks)
      : chunks_(std::move(chunks)), stream_(::ZSTD_createDStream(), &::ZSTD_freeDStream) {
    if (!stream_) {
      throw std::bad_alloc();
    }
  }

  std::size_t read(std::span<char> buffer) override {
    while (!buffer.empty()) {
      const std::span<char> in = chunks_.rest();
      // What has been taken may have more bytes in it than there was room for.
      if (in.empty() && !(in_frame_ && full_)) {
        if (in_frame_) {
          chunks_.fail("end too early");
        }
        return 0;
      }
      // A frame that is there as a whole is decoded by other rules: a window that is too large for
      // a stream is none there. Its header in single bytes makes the outcome that of a stream.
      const std::size_t given = header_left_ != 0 ? std::min<std::size_t>(in.size(), 1) : in.size();
      ZSTD_inBuffer from{in.data(), given, 0};
      ZSTD_outBuffer to{buffer.data(), buffer.size(), 0};
      const std::size_t result = ::ZSTD_decompressStream(stream_.get(), &to, &from);
      if (::ZSTD_isError(result) != 0) {
        if (::ZSTD_getErrorCode(result) == ZSTD_error_frameParameter_windowTooLarge) {
          chunks_.fail("need a window of more than 128 MiB");
        }
        chunks_.fail("are damaged");
      }
      chunks_.take(from.pos);
      in_frame_ = result != 0;
      header_left_ = in_frame_ ? header_left_ - std::min(header_left_, from.pos) : kLongestHeader;
      full_ = to.pos == to.size;
      if (to.pos != 0) {
        return to.pos;
      }
    }
    return 0;
  }

 private:
  Chunks chunks_;
  std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream_;
  bool in_frame_ = false;
  bool full_ = false;
  std::size_t header_left_ = kLongestHeader;
};
#endif

/// Looks at the first bytes when they are read: a pipe may not have any yet.
class AnySource final : public ByteSource {
 public:
  AnySource(std::unique_ptr<ByteSource> source, std::string_view name)
      : source_(std::move(source)), name_(name) {}

  std::size_t read(std::span<char> buffer) override {
    if (!looked_ && !buffer.empty()) {
      looked_ = true;
      look();
    }
    if (front_.empty()) {
      return source_->read(buffer);
    }
    const std::size_t count = front_.copy(buffer.data(), buffer.size());
    front_.erase(0, count);
    return count;
  }

  std::uint64_t total() const noexcept override { return source_->total(); }

 private:
  /// Reads no more than it takes to know.
  void look() {
    const auto may_be = [this](std::string_view magic) {
      return magic.starts_with(std::string_view(front_).substr(0, magic.size()));
    };
    while (front_.size() < kZstd.size() && (may_be(kGzip) || may_be(kZstd))) {
      char next = 0;
      if (source_->read({&next, 1}) == 0) {
        break;
      }
      front_ += next;
    }
    if (front_.starts_with(kGzip)) {
      source_ = std::make_unique<GzipSource>(chunks("gzip"));
    } else if (front_ == kZstd) {
#ifdef TENDONLIFE_ZSTD
      source_ = std::make_unique<ZstdSource>(chunks("zstd"));
#else
      throw InputError(name_, 0, 0, "compressed by zstd, which this program was built without",
                       "what zstd -d makes of it, or gzip");
#endif
    }
  }

  Chunks chunks(std::string_view format) {
    Chunks all(std::move(source_), name_, format, front_);
    front_.clear();
    return all;
  }

  std::unique_ptr<ByteSource> source_;
  std::string name_;
  std::string front_;
  bool looked_ = false;
};

}  // namespace

std::unique_ptr<ByteSource> decompressed(std::unique_ptr<ByteSource> source,
                                         std::string_view name) {
  return std::make_unique<AnySource>(std::move(source), name);
}

std::unique_ptr<ByteSource> open_input(const std::filesystem::path& path,
                                       std::string_view accepted) {
  return decompressed(hal::files::open_source(path, accepted), hal::files::file_name(path));
}

}  // namespace host_sim
