#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/protocol/authority/cmac.hpp"
#include "firmware/protocol/messages.hpp"
#include "hal/clock.hpp"
#include "lifemodel/support/saturating.hpp"

namespace protocol::authority {

using Nonce = std::array<std::byte, 16>;

inline constexpr std::size_t kMacBytes = 8;
using Mac = std::array<std::byte, kMacBytes>;

/// What a client asks for under authority.
struct Command {
  std::uint16_t routine = 0;
  std::span<const std::byte> arguments{};    ///< 0 .. 255 bytes
  std::span<const std::byte> transferred{};  ///< before, where the routine takes that
  std::uint32_t storage_counter = 0;         ///< as the client read it
};

/// The code that proves a command: AES-CMAC, cut to its first 8 bytes, over
///
///   0  4  "TLA1", so that the key proves nothing else
///   4  1  node
///   5  2  routine, the high byte first, as in the request
///   7  1  length of the arguments
///   8 16  nonce, as the node issued it
///  24  4  storage counter, little-endian
///  28  .  arguments, as in the request
///   .  .  what was transferred before, where the routine takes that
constexpr Mac mac(const Key& key, Node node, const Command& command, const Nonce& nonce) {
  Cmac cmac(key);
  for (const char letter : {'T', 'L', 'A', '1'}) {
    cmac.add(static_cast<std::byte>(letter));
  }
  cmac.add(std::byte{node});
  cmac.add(static_cast<std::byte>(command.routine >> 8));
  cmac.add(static_cast<std::byte>(command.routine));
  cmac.add(static_cast<std::byte>(command.arguments.size()));
  cmac.add(nonce);
  for (int shift = 0; shift < 32; shift += 8) {
    cmac.add(static_cast<std::byte>(command.storage_counter >> shift));
  }
  cmac.add(command.arguments);
  cmac.add(command.transferred);
  const Block whole = cmac.finish();
  Mac result{};
  std::copy_n(whole.begin(), result.size(), result.begin());
  return result;
}

inline constexpr std::uint32_t kFreeFailures = 3;  ///< failures that lock for the first time
inline constexpr hal::Time kFirstBackoff = hal::seconds(10);
inline constexpr std::uint32_t kMostDoublings = 6;
/// Failures from which on no further one makes the lock longer.
inline constexpr std::uint32_t kMostFailures = kFreeFailures + kMostDoublings;

/// How long nothing is allowed after so many failures since the last success: nothing, 10 s from
/// the third on, twice as long with each one more, at most 640 s.
constexpr hal::Time backoff(std::uint32_t failures) {
  if (failures < kFreeFailures) {
    return {};
  }
  const std::uint32_t counted = failures < kMostFailures ? failures : kMostFailures;
  return {kFirstBackoff.us << (counted - kFreeFailures)};
}

/// What the gate says to a command; the first that applies.
enum class Verdict : std::uint8_t {
  granted,
  disabled,       ///< the key is all zero
  locked_out,     ///< within the backoff after failures
  nonce_used,     ///< no nonce is open: none was issued, or it was used
  nonce_expired,  ///< older than kNonceLife
  wrong_mac,
  wrong_counter,  ///< it is proven, but for a storage counter that the node did not have meanwhile
};

/// The reason in words.
constexpr const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::granted:
      return "granted";
    case Verdict::disabled:
      return "this node has no key, so nothing is allowed";
    case Verdict::locked_out:
      return "locked for some time after failures";
    case Verdict::nonce_used:
      return "no nonce is open: read a fresh one for each command";
    case Verdict::nonce_expired:
      return "the nonce is older than 5 s";
    case Verdict::wrong_mac:
      return "the code does not prove the command";
    case Verdict::wrong_counter:
      return "the storage counter is not that of the node";
  }
  return "unknown";
}

inline constexpr hal::Time kNonceLife = hal::seconds(5);

/// Decides who may do what cannot be undone.
///
/// A nonce serves one command, granted or not. What does not prove that it comes from who holds the
/// key is a failure; a grant forgives them all. What holds off guessing is backoff().
///
/// A node saves when it has to, also while a client makes its command. So each storage counter
/// proves that the node has had since it issued the nonce, or that was read before, at most
/// kNonceLife ago.
class Gate {
 public:
  constexpr Gate(Node node, const Key& key) : key_(key), node_(node) {}

  /// Takes up the failures of before a restart; begins locked where there were enough of them.
  constexpr void resume(std::uint32_t failures, hal::Time now) {
    failures_ = failures;
    locked_until_ = now + backoff(failures);
  }

  /// The storage counter was read.
  constexpr void note_read(std::uint32_t storage_counter, hal::Time now) {
    read_counter_ = storage_counter;
    read_until_ = now + kNonceLife;
  }

  /// Opens a fresh nonce, in place of the one before. False, and none is open, where it is the same
  /// as that: its source is broken.
  [[nodiscard]] constexpr bool issue(const Nonce& nonce, std::uint32_t storage_counter,
                                     hal::Time now) {
    open_ = nonce != nonce_;
    nonce_ = nonce;
    issued_ = now;
    first_counter_ = now < read_until_ ? read_counter_ : storage_counter;
    return open_;
  }

  /// Judges a command and uses up the nonce.
  [[nodiscard]] constexpr Verdict check(const Command& command, std::span<const std::byte> code,
                                        std::uint32_t storage_counter, hal::Time now) {
    if (!enabled()) {
      return Verdict::disabled;
    }
    if (locked(now)) {
      return Verdict::locked_out;
    }
    const Verdict verdict = judge(command, code, storage_counter, now);
    open_ = false;
    if (verdict == Verdict::granted) {
      failures_ = 0;
    } else if (verdict != Verdict::wrong_counter) {
      failures_ = lifemodel::saturating_add(failures_, 1u);
      locked_until_ = now + backoff(failures_);
    }
    return verdict;
  }

  [[nodiscard]] constexpr bool enabled() const { return !equal(key_, Key{}); }
  [[nodiscard]] constexpr bool locked(hal::Time now) const { return now < locked_until_; }
  /// Time until the lock opens.
  [[nodiscard]] constexpr hal::Time lock_left(hal::Time now) const {
    return locked(now) ? locked_until_ - now : hal::Time{};
  }
  /// Since the last grant.
  [[nodiscard]] constexpr std::uint32_t failures() const { return failures_; }

 private:
  [[nodiscard]] constexpr Verdict judge(const Command& command, std::span<const std::byte> code,
                                        std::uint32_t storage_counter, hal::Time now) const {
    if (!open_) {
      return Verdict::nonce_used;
    }
    if (now - issued_ >= kNonceLife) {
      return Verdict::nonce_expired;
    }
    if (!equal(mac(key_, node_, command, nonce_), code)) {
      return Verdict::wrong_mac;
    }
    const bool had =
        command.storage_counter >= first_counter_ && command.storage_counter <= storage_counter;
    return had ? Verdict::granted : Verdict::wrong_counter;
  }

  Key key_;
  Nonce nonce_{};
  hal::Time issued_{};
  hal::Time locked_until_{};
  hal::Time read_until_{};
  std::uint32_t read_counter_ = 0;
  std::uint32_t first_counter_ = 0;  ///< that proves with the open nonce
  std::uint32_t failures_ = 0;
  Node node_;
  bool open_ = false;
};

}  // namespace protocol::authority
