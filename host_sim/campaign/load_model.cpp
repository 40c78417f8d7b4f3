#include "host_sim/campaign/load_model.hpp"

#include <fmt/format.h>

#include <numbers>
#include <utility>

#include "host_sim/reference/equations.hpp"

namespace host_sim {
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

LoadModel::LoadModel(const Campaign::Nominal& nominal, Place model)
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
  const Place& place = given.place();
  model_.fail(fmt::format("no table [model.{}]", table),
              fmt::format("[model.{}] with {}, which the load at {}:{} needs", table, key,
                          place.file, place.line));
}

}  // namespace host_sim
