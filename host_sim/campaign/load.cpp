#include "host_sim/campaign/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "host_sim/reference/equations.hpp"

namespace host_sim {

using hal::files::NumberKey;
using hal::files::NumberRange;

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

std::string_view load_keys_prose() {
  return kWords;
}

std::string_view load_keys_prose_of_use() {
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

const FilePosition& GivenLoad::place() const {
  return std::find_if(numbers.begin(), numbers.end(),
                      [](const Number& number) { return number.given; })
      ->place;
}

namespace {

void refuse_at_limit(const GivenLoad& given, std::string_view what, double tension_N,
                     double ultimate_tension_N) {
  if (!(tension_N < ultimate_tension_N)) {
    given.place().fail(
        fmt::format("{} is {:.6g} N", what, tension_N),
        fmt::format("less than ultimate_tension_N, which is {}", ultimate_tension_N));
  }
}

}  // namespace

LoadModel::LoadModel(const NominalModel& nominal, FilePosition model)
    : nominal_(&nominal), model_(std::move(model)) {}

Campaign::Load LoadModel::load(const GivenLoad& given) const {
  const LoadKind kind = given.kind();
  Campaign::Load load;
  if (kind == LoadKind::effective_tension) {
    load.input_tension_amplitude_N = given.value(kEffectiveTensionKey);
    load.effective_tension_N = load.input_tension_amplitude_N;
    if (nominal_->cable) {
      refuse_at_limit(given, "effective tension", load.effective_tension_N,
                      nominal_->cable->ultimate_tension_N);
    }
  } else {
    const double ultimate_N = ultimate_tension_N(given);
    if (kind == LoadKind::output_tension) {
      input_from_output(given, load);
    } else {
      load.input_tension_mean_N = given.value(kInputMeanKey);
      load.input_tension_amplitude_N = given.value(kInputAmplitudeKey);
    }
    refuse_at_limit(given, "peak of the input tension",
                    load.input_tension_mean_N + load.input_tension_amplitude_N, ultimate_N);
    load.effective_tension_N = reference::gerber_effective_tension(
        {load.input_tension_mean_N, load.input_tension_amplitude_N}, ultimate_N);
  }
  if (load.effective_tension_N < kLeastTension_N) {
    given.place().fail(fmt::format("effective tension is {:.6g} N", load.effective_tension_N),
                       fmt::format("a load with at least {} N of it", kLeastTension_N));
  }
  return load;
}

double LoadModel::ultimate_tension_N(const GivenLoad& given) const {
  if (!nominal_->cable) {
    fail_missing(given, "cable", "ultimate_tension_N");
  }
  return nominal_->cable->ultimate_tension_N;
}

void LoadModel::input_from_output(const GivenLoad& given, Campaign::Load& load) const {
  if (!nominal_->sheath) {
    fail_missing(given, "sheath", "friction_coefficient");
  }
  const double bend_angle_deg = given.value(kBendAngleKey);
  const double efficiency = reference::capstan_efficiency(
      nominal_->sheath->friction_coefficient, bend_angle_deg * std::numbers::pi / 180.0);
  const reference::MeanAmplitude input = reference::input_tension_range(
      {given.value(kOutputMeanKey), given.value(kOutputAmplitudeKey)}, efficiency);
  load.bend_angle_deg = bend_angle_deg;
  load.input_tension_mean_N = input.mean_N;
  load.input_tension_amplitude_N = input.amplitude_N;
}

void LoadModel::fail_missing(const GivenLoad& given, std::string_view table,
                             std::string_view key) const {
  const FilePosition& place = given.place();
  model_.fail(fmt::format("no table [model.{}]", table),
              fmt::format("[model.{}] with {}, which the load at {}:{} needs", table, key,
                          place.file, place.line));
}

}  // namespace host_sim
