#pragma once

#include <cstdint>
#include <optional>

#include "host_sim/extension/apply.hpp"
#include "host_sim/io/model.hpp"
#include "host_sim/io/profile.hpp"
#include "host_sim/reference/equations.hpp"
#include "host_sim/replay/virtual_board.hpp"
#include "lifemodel/block/extended_block.hpp"
#include "lifemodel/extension/corrector.hpp"

namespace host_sim {

/// Turns rows of a profile into input tension, once by the conversions of the target and once in
/// double precision.
class ProfileInput {
 public:
  /// @param model with the extensions that act on the profile alone
  /// @param start_cycle that the sheath has seen before
  /// Preconditions: the model has a drive where the profile holds motor current; `parameters` are
  /// those of the model and outlive this object.
  ProfileInput(const ProfileReader& profile, const Model& model,
               const lifemodel::ExtendedParameters& parameters, std::uint32_t start_cycle);

  /// Samples are missing before the next row.
  void gap();

  /// Sets the tensions of the next row; raises flags as the target would.
  void take(const ProfileRow& row, lifemodel::Flags& flags);

  [[nodiscard]] lifemodel::Tension tension() const { return tension_; }
  /// The row as the sensor of a board would give it.
  [[nodiscard]] BoardSample sample() const;
  /// What became of the row on its way into that sample.
  [[nodiscard]] lifemodel::Flags sample_flags() const { return sample_flags_; }
  [[nodiscard]] double tension_N() const { return tension_N_; }

 private:
  /// What the extended equations read besides the load, as the target gets it and exactly.
  struct Extended {
    Extended(const Model& model, const lifemodel::ExtendedParameters& parameters,
             std::uint32_t start_cycle);
    lifemodel::extension::Corrector corrector;
    ExtendedInput exact;
    lifemodel::extension::Conditions conditions;
    Circumstances circumstances;
    bool pulled = true;  ///< before the last turn
  };

  void take_output(const ProfileRow& row);
  void take_surroundings(const ProfileRow& row);
  void take_extended(const ProfileRow& row);
  [[nodiscard]] lifemodel::Direction direction() const;
  [[nodiscard]] lifemodel::Tension converted(lifemodel::Flags& flags);

  InputKind kind_;
  bool has_bend_angle_;
  double ultimate_tension_N_;
  double friction_coefficient_;
  double model_bend_rad_;
  const lifemodel::Parameters& parameters_;
  std::optional<Extended> extended_;
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
