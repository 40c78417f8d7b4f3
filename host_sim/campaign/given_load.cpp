#include "host_sim/campaign/given_load.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace host_sim {
namespace {

constexpr NumberRange kTension_N{0.0, 1e6};

constexpr std::array<NumberKey, kLoadKeyCount> kKeys{{
    {"bend_angle_deg", "deg", {0.0, 1800.0}},
    {"output_tension_mean_N", "N", kTension_N},
    {"output_tension_amplitude_N", "N", kTension_N},
    {"input_tension_mean_N", "N", kTension_N},
    {"input_tension_amplitude_N", "N", kTension_N},
    {"effective_tension_N", "N", kTension_N},
}};

constexpr std::array<LoadKind, kLoadKeyCount> kKinds{
    LoadKind::output_tension, LoadKind::output_tension, LoadKind::output_tension,
    LoadKind::input_tension,  LoadKind::input_tension,  LoadKind::effective_tension};

constexpr std::string_view kWords =
    "bend_angle_deg with output_tension_mean_N and output_tension_amplitude_N, or "
    "input_tension_mean_N with input_tension_amplitude_N";
constexpr std::string_view kWordsOfUse =
    "bend_angle_deg with output_tension_mean_N and output_tension_amplitude_N, or "
    "input_tension_mean_N with input_tension_amplitude_N, or effective_tension_N";

}  // namespace

std::span<const NumberKey, kLoadKeyCount> load_keys() {
  return kKeys;
}

std::string_view load_words() {
  return kWords;
}

std::string_view load_words_of_use() {
  return kWordsOfUse;
}

LoadKind GivenLoad::kind() const {
  const auto* const first = std::find_if(numbers.begin(), numbers.end(),
                                         [](const Number& number) { return number.given; });
  if (first == numbers.end()) {
    return LoadKind::none;
  }
  const auto first_id = static_cast<std::size_t>(first - numbers.begin());
  const LoadKind kind = kKinds[first_id];
  for (std::size_t id = 0; id < kLoadKeyCount; ++id) {
    const Number& number = numbers[id];
    if (number.given && kKinds[id] != kind) {
      number.place.fail(fmt::format("{} beside {}", kKeys[id].name, kKeys[first_id].name),
                        accepted);
    }
    if (!number.given && kKinds[id] == kind) {
      number.place.fail(fmt::format("{} without {}", kKeys[first_id].name, kKeys[id].name),
                        accepted);
    }
  }
  return kind;
}

void GivenLoad::check() const {
  [[maybe_unused]] const LoadKind checked = kind();
}

GivenLoad GivenLoad::only(LoadKind kind) const {
  GivenLoad part = *this;
  for (std::size_t id = 0; id < kLoadKeyCount; ++id) {
    part.numbers[id].given = numbers[id].given && kKinds[id] == kind;
  }
  return part;
}

const Place& GivenLoad::place() const {
  return std::find_if(numbers.begin(), numbers.end(),
                      [](const Number& number) { return number.given; })
      ->place;
}

}  // namespace host_sim
