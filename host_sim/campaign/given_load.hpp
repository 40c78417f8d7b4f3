#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "host_sim/campaign/place.hpp"
#include "host_sim/io/number_range.hpp"

namespace host_sim {

/// The places of the numbers in load_keys().
enum LoadKeyId : unsigned {
  kBendAngleKey,
  kOutputMeanKey,
  kOutputAmplitudeKey,
  kInputMeanKey,
  kInputAmplitudeKey,
  kEffectiveTensionKey,  ///< in campaign.toml alone
  kLoadKeyCount,
};

/// The numbers in the first places of load_keys() that a CSV file may give.
inline constexpr std::size_t kLoadColumnCount = kEffectiveTensionKey;

/// The numbers that may give a load.
std::span<const NumberKey, kLoadKeyCount> load_keys();

/// What gives a load in a CSV file, in words; and in a use of campaign.toml.
std::string_view load_words();
std::string_view load_words_of_use();

enum class LoadKind {
  none,
  output_tension,  ///< with the bend angle
  input_tension,
  effective_tension,
};

/// A load as it stands in a file.
struct GivenLoad {
  struct Number {
    bool given = false;
    double value = 0;
    Place place;  ///< also of a cell that is empty
  };
  std::array<Number, kLoadKeyCount> numbers{};
  std::string_view accepted = load_words();  ///< what errors say is accepted

  /// What kind of load the numbers give.
  /// @throws InputError where they give half a kind, or more than one
  [[nodiscard]] LoadKind kind() const;

  /// The same for its errors alone.
  void check() const;

  /// The numbers of one kind alone.
  [[nodiscard]] GivenLoad only(LoadKind kind) const;

  [[nodiscard]] double value(LoadKeyId id) const { return numbers[id].value; }

  /// Where the first of the numbers that are given stands.
  /// @pre kind() is not none
  [[nodiscard]] const Place& place() const;
};

}  // namespace host_sim
