#include "host_sim/replay/profile_input.hpp"

#include "host_sim/replay/constants.hpp"
#include "lifemodel/pack/pack.hpp"
#include "lifemodel/pack/samples.hpp"

namespace host_sim {

using hal::files::InputKind;
using hal::files::ProfileReader;
using hal::files::ProfileRow;

namespace {

using lifemodel::Direction;
using lifemodel::Tension;
using lifemodel::pack::from_double;
using lifemodel::pack::saturating;
using lifemodel::pack::to_double;

}  // namespace

ProfileInput::ProfileInput(const ProfileReader& profile, const Model& model,
                           const lifemodel::ExtendedParameters& parameters,
                           std::uint32_t start_cycle)
    : kind_(profile.kind()),
      has_bend_angle_(profile.has_bend_angle()),
      has_velocity_(profile.channels()[hal::files::kTendonVelocity]),
      rate_Hz_(model.counting.sample_rate_Hz),
      ultimate_tension_N_(model.cable.ultimate_tension_N),
      friction_coefficient_(model.sheath.friction_coefficient),
      model_bend_rad_(radians(model.sheath.bend_angle_deg)),
      parameters_(parameters.nominal) {
  if (parameters.extension.effects != 0) {
    extended_.emplace(model, parameters, start_cycle);
  }
  if (!has_velocity_ && profile.channels()[hal::files::kMotorAngle] && model.drive) {
    radius_m_ = model.drive->spool_radius_m() / model.drive->gear_ratio;
  }
  if (kind_ == InputKind::kMotorCurrent) {
    drive_ = model.drive->reference();
  }
}

ProfileInput::Extended::Extended(const Model& model,
                                 const lifemodel::ExtendedParameters& parameters,
                                 std::uint32_t start_cycle)
    : corrector(parameters.nominal, parameters.extension), exact(model) {
  corrector.start_at(start_cycle);
  exact_covariates.cycle = start_cycle;
}

void ProfileInput::gap() {
  angle_rad_.reset();
  if (extended_) {
    extended_->corrector.gap();
    extended_->exact.gap();
  }
}

void ProfileInput::take(const ProfileRow& row, lifemodel::Flags& flags) {
  sample_flags_ = {};
  take_motion(row);
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
  if (extended_) {
    take_surroundings(row);
    take_extended(row);
  }
  flags = flags | sample_flags_;
  tension_ = converted(flags);
}

void ProfileInput::take_motion(const ProfileRow& row) {
  if (!has_motion()) {
    return;
  }
  double velocity_m_s = row.tendon_velocity_m_s;
  if (!has_velocity_ && radius_m_ > 0) {
    velocity_m_s = angle_rad_ ? (row.motor_angle_rad - *angle_rad_) * rate_Hz_ * radius_m_ : 0;
    angle_rad_ = row.motor_angle_rad;
  }
  // What is faster has gone far enough in one sample.
  velocity_ = from_double<app::Velocity>(velocity_m_s);
}

void ProfileInput::take_output(const ProfileRow& row) {
  if (!extended_) {
    direction_ = reference::direction_of(row.tendon_velocity_m_s, direction_);
  }
  const double bend_rad = has_bend_angle_ ? radians(row.bend_angle_deg) : model_bend_rad_;
  tension_N_ = reference::input_tension_from_output(
      row.value, reference::capstan_efficiency(friction_coefficient_, bend_rad), direction_);
  measured_ = saturating<Tension>(row.value / ultimate_tension_N_, sample_flags_);
  bend_ = has_bend_angle_ ? from_double<lifemodel::Angle>(bend_rad) : parameters_.bend;
}

void ProfileInput::take_surroundings(const ProfileRow& row) {
  lifemodel::extension::Covariates& target = extended_->covariates;
  target = lifemodel::pack::covariates({row.tendon_velocity_m_s, row.motor_angle_rad,
                                        row.sheath_temperature_C, row.winding_temperature_C},
                                       sample_flags_);
  if (kind_ == InputKind::kMotorCurrent) {
    target.velocity = velocity_;
  }

  Covariates& exact = extended_->exact_covariates;
  // The direction is the sample's: what rounds to no velocity keeps it.
  direction_ = reference::direction_of(to_double(target.velocity), direction_);
  exact.direction = direction_ == reference::Direction::kPulling ? 1 : -1;
  exact.velocity_m_s = row.tendon_velocity_m_s;
  exact.motor_angle_rad = row.motor_angle_rad;
  exact.sheath_temperature_C = row.sheath_temperature_C;
  exact.winding_temperature_C = row.winding_temperature_C;
  const double turned_m_s = to_double(lifemodel::extension::Corrector::kTurned);
  if (extended_->pulled ? exact.velocity_m_s < -turned_m_s : exact.velocity_m_s > turned_m_s) {
    extended_->pulled = !extended_->pulled;
    exact.cycle += 0.5;
  }
}

/// In place of the nominal equations.
void ProfileInput::take_extended(const ProfileRow& row) {
  if (kind_ == InputKind::kMotorCurrent) {
    tension_N_ = extended_->exact.from_current_N(row.value, extended_->exact_covariates);
  } else if (kind_ == InputKind::kOutputTension) {
    extended_->exact_covariates.bend_angle_rad =
        has_bend_angle_ ? radians(row.bend_angle_deg) : model_bend_rad_;
    tension_N_ = extended_->exact.from_output_N(row.value, extended_->exact_covariates);
  }
}

Tension ProfileInput::converted(lifemodel::Flags& flags) {
  using lifemodel::extension::DriveSample;
  using lifemodel::extension::SheathSample;
  switch (kind_) {
    case InputKind::kInputTension:
      return measured_;
    case InputKind::kMotorCurrent:
      return extended_ ? extended_->corrector.input_tension(
                             DriveSample{current_, extended_->covariates}, flags)
                       : parameters_.drive.tension(current_, flags);
    case InputKind::kOutputTension:
      return extended_ ? extended_->corrector.input_tension(
                             SheathSample{measured_, bend_, extended_->covariates}, flags)
                       : parameters_.capstan.input_tension(measured_, bend_, direction(), flags);
  }
  return {};
}

Direction ProfileInput::direction() const {
  return direction_ == reference::Direction::kPulling ? Direction::pulling : Direction::releasing;
}

BoardSample ProfileInput::sample() const {
  switch (kind_) {
    case InputKind::kInputTension:
      return app::Moving<Tension>{measured_, velocity_};
    case InputKind::kMotorCurrent:
      if (extended_) {
        return lifemodel::extension::DriveSample{current_, extended_->covariates};
      }
      return app::Moving<lifemodel::MotorCurrent>{current_, velocity_};
    case InputKind::kOutputTension:
      if (extended_) {
        return lifemodel::extension::SheathSample{measured_, bend_, extended_->covariates};
      }
      return app::OutputTension{measured_, direction(), bend_, velocity_};
  }
  return app::Moving<Tension>{measured_, velocity_};
}

}  // namespace host_sim
