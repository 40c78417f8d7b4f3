#pragma once

#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/tension/hypothesis.hpp"

namespace host_sim::diagnose {

/// The sessions that the nominal model misses most, measured against predicted by both models,
/// thinned: at most three.
std::vector<TracePicture> trace_pictures(const Evidence& evidence,
                                         std::span<const Component> model);

/// Gain and friction of each session alone.
std::vector<SessionRefit> session_refits(const Evidence& evidence);

/// The residual of both models by each probe. The envelope is 1.96 standard deviations of the mean
/// of a bin: noise of samples that follow each other with the autocorrelation, and the scatter of
/// the sessions that reach the bin.
std::vector<ResidualPicture> residual_pictures(const Evidence& evidence,
                                               const std::vector<Probe>& probes,
                                               std::span<const Component> model);

}  // namespace host_sim::diagnose
