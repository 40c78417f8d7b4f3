#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware/app/config.hpp"
#include "hal/slcan/line.hpp"

namespace boards::qemu_mps2 {

/// What went wrong, and with what: an option, or null for the run itself. Nothing did where `what`
/// is null.
struct [[nodiscard]] Failure {
  const char* about = nullptr;
  const char* what = nullptr;

  explicit operator bool() const { return what != nullptr; }
};

/// What the command line says, in words NAME=VALUE:
///
///   profile=FILE    the samples; see format.hpp
///   block=FILE      the parameter block of tendons that the store has none for
///   events=FILE     what happens besides (virtual time only)
///   flash=FILE      the flash; made where it is missing. Without: erased, and gone at the end
///   summary=FILE    where to write how the run has ended
///   node=1..127     1 where nothing is said
///   key=32 digits   hexadecimal; without it nothing that needs authority is allowed
///   seed=0..4294967295
///   real_time=1     plays the samples again and again, each at its time, to a host on UART 0
///   seconds=N       how long, in real time; without end where nothing is said
struct Options {
  const char* profile = nullptr;
  const char* block = nullptr;
  const char* events = nullptr;
  const char* flash = nullptr;
  const char* summary = nullptr;
  app::Config config;
  std::uint32_t seed = 1;
  std::uint32_t seconds = 0;
  bool real_time = false;
};

/// Reads one word after another into Options.
class OptionReader {
 public:
  /// What is accepted, where the word is not; null where it is.
  const char* take(const char* word) {
    const std::string_view text(word);
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) {
      return "NAME=VALUE";
    }
    const std::string_view name = text.substr(0, equals);
    return take(name, word + equals + 1);
  }

  [[nodiscard]] const Options& options() const { return options_; }

 private:
  const char* take(std::string_view name, const char* value) {
    for (const auto& [known, field] : kFiles) {
      if (name == known) {
        options_.*field = value;
        return nullptr;
      }
    }
    if (name == "key") {
      return take_key(value) ? nullptr : "32 hexadecimal digits";
    }
    const auto number = decimal(value);
    if (name == "node") {
      options_.config.node = static_cast<protocol::Node>(number.value_or(0));
      return number && *number >= 1 && *number <= 127 ? nullptr : "1 .. 127";
    }
    if (name == "seed" || name == "seconds") {
      (name == "seed" ? options_.seed : options_.seconds) = number.value_or(0);
      return number ? nullptr : "0 .. 4294967295";
    }
    if (name == "real_time") {
      options_.real_time = number == 1u;
      return number && *number <= 1 ? nullptr : "0 or 1";
    }
    return "profile, block, events, flash, summary, node, key, seed, real_time and seconds";
  }

  bool take_key(std::string_view digits) {
    if (digits.size() != 2 * options_.config.key.size()) {
      return false;
    }
    for (std::size_t i = 0; i < options_.config.key.size(); ++i) {
      const auto byte = hal::slcan::hex_number(digits.substr(2 * i, 2));
      if (!byte) {
        return false;
      }
      options_.config.key[i] = static_cast<std::byte>(*byte);
    }
    return true;
  }

  static std::optional<std::uint32_t> decimal(std::string_view digits) {
    std::uint32_t number = 0;
    for (const char digit : digits) {
      if (digit < '0' || digit > '9' || __builtin_mul_overflow(number, 10u, &number) ||
          __builtin_add_overflow(number, static_cast<std::uint32_t>(digit - '0'), &number)) {
        return std::nullopt;
      }
    }
    return digits.empty() ? std::nullopt : std::optional(number);
  }

  struct File {
    std::string_view name;
    const char* Options::*field;
  };
  static constexpr std::array<File, 5> kFiles{
      File{"profile", &Options::profile}, File{"block", &Options::block},
      File{"events", &Options::events}, File{"flash", &Options::flash},
      File{"summary", &Options::summary}};

  Options options_;
};

}  // namespace boards::qemu_mps2
