#include "host_sim/replay/profile_input.hpp"

#include <cmath>

#include "host_sim/replay/constants.hpp"
#include "lifemodel/pack/pack.hpp"

namespace host_sim {
namespace {

using lifemodel::Direction;
using lifemodel::Tension;
using lifemodel::pack::from_double;

template <class Q>
Q saturating(double value, lifemodel::Flags& flags) {
  if (!(std::fabs(value) <= lifemodel::pack::to_double(Q::highest()))) {
    flags.raise(lifemodel::Flag::saturated);
  }
  return from_double<Q>(value);
}

}  // namespace

ProfileInput::ProfileInput(const ProfileReader& profile, const Model& model,
                           const lifemodel::Parameters& parameters)
    : kind_(profile.kind()),
      has_bend_angle_(profile.has_bend_angle()),
      ultimate_tension_N_(model.cable.ultimate_tension_N),
      friction_coefficient_(model.sheath.friction_coefficient),
      model_bend_rad_(radians(model.sheath.bend_angle_deg)),
      parameters_(parameters) {
  if (kind_ == InputKind::kMotorCurrent) {
    drive_ = drive_of(model);
  }
}

void ProfileInput::take(const ProfileRow& row, lifemodel::Flags& flags) {
  sample_flags_ = {};
  switch (kind_) {
    case InputKind::kInputTension:
      tension_N_ = row.value;
      measured_ = saturating<Tension>(row.value / ultimate_tension_N_, sample_flags_);
      break;
    case InputKind::kMotorCurrent:
      tension_N_ = reference::input_tension_from_current(row.value, drive_);
      current_ = saturating<lifemodel::MotorCurrent>(row.value, sample_flags_);
      break;
    case InputKind::kOutputTension:
      take_output(row);
      break;
  }
  flags = flags | sample_flags_;
  tension_ = converted(flags);
}

void ProfileInput::take_output(const ProfileRow& row) {
  direction_ = reference::direction_of(row.tendon_velocity_m_s, direction_);
  const double bend_rad = has_bend_angle_ ? radians(row.bend_angle_deg) : model_bend_rad_;
  tension_N_ = reference::input_tension_from_output(
      row.value, reference::capstan_efficiency(friction_coefficient_, bend_rad), direction_);
  measured_ = saturating<Tension>(row.value / ultimate_tension_N_, sample_flags_);
  bend_ = has_bend_angle_ ? from_double<lifemodel::Angle>(bend_rad) : parameters_.bend;
}

Tension ProfileInput::converted(lifemodel::Flags& flags) const {
  switch (kind_) {
    case InputKind::kInputTension:
      return measured_;
    case InputKind::kMotorCurrent:
      return parameters_.drive.tension(current_, flags);
    case InputKind::kOutputTension:
      return parameters_.capstan.input_tension(measured_, bend_, direction(), flags);
  }
  return {};
}

Direction ProfileInput::direction() const {
  return direction_ == reference::Direction::kPulling ? Direction::pulling : Direction::releasing;
}

BoardSample ProfileInput::sample() const {
  switch (kind_) {
    case InputKind::kInputTension:
      return measured_;
    case InputKind::kMotorCurrent:
      return current_;
    case InputKind::kOutputTension:
      return app::OutputTension{measured_, direction(), bend_};
  }
  return measured_;
}

}  // namespace host_sim
