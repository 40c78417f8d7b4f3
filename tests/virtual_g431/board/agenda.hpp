#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace virtual_g431 {

/// Time of the board in units of 1/1360 us, of which every clock that occurs has whole periods:
/// 170 MHz 8, 42.5 MHz 32, 16 MHz 85.
using Ticks = std::uint64_t;
inline constexpr Ticks kMicrosecond = 1360;
inline constexpr Ticks kMillisecond = 1000 * kMicrosecond;
inline constexpr Ticks kSecond = 1000 * kMillisecond;
inline constexpr Ticks kNever = std::numeric_limits<Ticks>::max();

constexpr double to_ms(Ticks ticks) {
  return static_cast<double>(ticks) / static_cast<double>(kMillisecond);
}

/// What happens when. Peripherals put their future in; the core moves the time.
class Agenda {
 public:
  using Entry = std::pair<Ticks, std::uint64_t>;

  [[nodiscard]] Ticks now() const { return now_; }
  [[nodiscard]] Ticks next() const {
    return entries_.empty() ? kNever : entries_.begin()->first.first;
  }

  /// The entry, for cancel(). A time that is past means now.
  Entry at(Ticks time, std::function<void()> what) {
    const Entry entry{time < now_ ? now_ : time, ++count_};
    entries_.emplace(entry, std::move(what));
    return entry;
  }
  Entry in(Ticks span, std::function<void()> what) { return at(now_ + span, std::move(what)); }
  /// Nothing where it has happened.
  void cancel(const Entry& entry) { entries_.erase(entry); }

  /// Everything up to `time` happens, each at its own time.
  void advance_to(Ticks time) {
    while (next() <= time) {
      auto first = entries_.extract(entries_.begin());
      now_ = first.key().first > now_ ? first.key().first : now_;
      first.mapped()();
    }
    now_ = time > now_ ? time : now_;
  }

 private:
  Ticks now_ = 0;
  std::uint64_t count_ = 0;
  std::map<Entry, std::function<void()>> entries_;
};

}  // namespace virtual_g431
