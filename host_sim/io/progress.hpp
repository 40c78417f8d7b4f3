#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace host_sim {

/// The text of a progress bar of at most `width` columns after `elapsed_s` seconds, e.g.
/// `replay [#####-----]  50 %  210 MB/s  0:12 left`; without a known `total` bytes and rate only.
std::string progress_text(std::string_view label, std::uint64_t done, std::uint64_t total,
                          double elapsed_s, std::size_t width);

/// The same for work that is counted in shares, 0 .. 1, of the whole, e.g.
/// `calibrate [#####-----]  50 %  0:12 left`.
std::string share_text(std::string_view label, double share, double elapsed_s, std::size_t width);

/// A progress bar on a terminal, redrawn ten times a second at most and erased at the end. Where
/// the file descriptor is not a terminal nothing is written.
class Progress {
 public:
  /// `total` in bytes, 0 if unknown or if the work is counted in shares.
  explicit Progress(std::string_view label, std::uint64_t total = 0,
                    int descriptor = STDERR_FILENO);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Says that `done` bytes are done. Cheap, but meant for each block, not for each sample.
  void update(std::uint64_t done);

  /// Says that `share`, 0 .. 1, of the whole work is done.
  void update_share(double share);

  /// Erases the bar; also done by the destructor.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  bool due() const;
  double elapsed_s() const;
  std::size_t width() const;
  void draw(const std::string& text);

  std::string label_;
  std::uint64_t total_;
  int descriptor_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_;
  Clock::time_point next_draw_;
};

}  // namespace host_sim
