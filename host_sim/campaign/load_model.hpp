#pragma once

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/given_load.hpp"
#include "host_sim/campaign/place.hpp"

namespace host_sim {

/// Makes loads of what files give, with the nominal model of a campaign.
class LoadModel {
 public:
  /// `model` is the place of [model] in campaign.toml, for errors where it lacks a table. The
  /// nominal model must outlive this.
  LoadModel(const Campaign::Nominal& nominal, Place model);

  /// Input tension from output tension by the capstan equation (14), (12) and (13), effective
  /// tension by Gerber's equation (11). An effective tension that is given stands for an input
  /// tension of this amplitude around zero.
  /// @pre given.kind() is not none
  /// @throws InputError where the model lacks what is needed, where the input tension reaches the
  /// ultimate tension, and where the effective tension is below kLeastTension_N
  Campaign::Load load(const GivenLoad& given) const;

  static constexpr double kLeastTension_N = 1e-3;

 private:
  double ultimate_tension_N(const GivenLoad& given) const;
  void input_from_output(const GivenLoad& given, Campaign::Load& load) const;
  [[noreturn]] void fail_missing(const GivenLoad& given, std::string_view table,
                                 std::string_view key) const;

  const Campaign::Nominal* nominal_;
  Place model_;
};

}  // namespace host_sim
