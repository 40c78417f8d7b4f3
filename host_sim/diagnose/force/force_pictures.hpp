#pragma once

#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/force_fit.hpp"

namespace host_sim::diagnose {

/// A model with what it leaves of the input force, by record and sample.
struct PicturedModel {
  double gain = 1;
  std::vector<std::vector<double>> left_N;
};

/// The first sessions, as one model and the other have their output force.
std::vector<TracePicture> traces_of(const ForceData& data, const PicturedModel& before,
                                    const PicturedModel& after);

/// Of each effect that lessens the error, in the session where it does so most.
/// @param stairs each with an effect more than the one before
/// @param steps of the same models
std::vector<CausePicture> causes_of(const ForceData& data, const std::vector<PicturedModel>& stairs,
                                    const std::vector<Step>& steps);

/// Gain and friction that suit each session beside the nominal model.
std::vector<SessionRefit> session_refits_of(const ForceData& data, const ForceFit& nominal);

}  // namespace host_sim::diagnose
