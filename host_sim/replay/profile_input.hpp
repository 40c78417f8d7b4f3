#pragma once

#include "host_sim/io/model.hpp"
#include "host_sim/io/profile.hpp"
#include "host_sim/reference/equations.hpp"
#include "host_sim/replay/virtual_board.hpp"
#include "lifemodel/block/parameters.hpp"

namespace host_sim {

/// Turns rows of a profile into input tension, once by the conversions of the target and once in
/// double precision.
class ProfileInput {
 public:
  /// Preconditions: the model has a drive where the profile holds motor current; `parameters`
  /// outlives this object.
  ProfileInput(const ProfileReader& profile, const Model& model,
               const lifemodel::Parameters& parameters);

  /// Sets the tensions of the next row; raises flags as the target would.
  void take(const ProfileRow& row, lifemodel::Flags& flags);

  [[nodiscard]] lifemodel::Tension tension() const { return tension_; }
  /// The row as the sensor of a board would give it.
  [[nodiscard]] BoardSample sample() const;
  /// What became of the row on its way into that sample.
  [[nodiscard]] lifemodel::Flags sample_flags() const { return sample_flags_; }
  [[nodiscard]] double tension_N() const { return tension_N_; }

 private:
  void take_output(const ProfileRow& row);
  [[nodiscard]] lifemodel::Direction direction() const;
  [[nodiscard]] lifemodel::Tension converted(lifemodel::Flags& flags) const;

  InputKind kind_;
  bool has_bend_angle_;
  double ultimate_tension_N_;
  double friction_coefficient_;
  double model_bend_rad_;
  const lifemodel::Parameters& parameters_;
  reference::Drive drive_{};
  reference::Direction direction_ = reference::Direction::kPulling;
  lifemodel::Flags sample_flags_;
  lifemodel::Tension measured_;
  lifemodel::MotorCurrent current_;
  lifemodel::Angle bend_;
  lifemodel::Tension tension_;
  double tension_N_ = 0;
};

}  // namespace host_sim
