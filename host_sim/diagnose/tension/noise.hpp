#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/diagnose/gram.hpp"

namespace host_sim::diagnose {

/// By session, a weight for each sample; none where all are 1.
using SampleWeights = std::vector<std::vector<double>>;

/// The variance of a sample is a^2 (1 + c q): a of each session, q the noise of both channels where
/// it is known, else 1/T_in^2 + 1/T_out^2, as a sensor's own noise is in newtons. Finds c and each
/// a by the normal likelihood of residuals that have mean zero, and gives weights of one over the
/// variance, over their mean; none where that is no likelier than one variance beyond doubt.
/// @param residuals one vector a session, as long as its samples
SampleWeights sample_weights(std::span<const Session> sessions,
                             const std::vector<Eigen::VectorXd>& residuals);

/// What is left in the samples when each session has every effect of the catalogue, in every shape,
/// to itself: more than any model explains.
struct SampleNoise {
  SampleWeights weights;       ///< one over the variance of a sample, of mean 1
  double autocorrelation = 0;  ///< of first order, once weighed, before the fits
  double sample_sd = 0;        ///< of the innovations, of ln T_out - ln T_in
};

/// Taken as white noise and noise of first order together, of which the fits take away what they
/// take away of simulated noise. The two count by their variance at low frequency.
/// @param wanted the effects and shapes that each session is fitted with
/// @param kept of these sessions
SampleNoise sample_noise(std::span<const Session> sessions, const effects::Baseline& baseline,
                         const std::vector<Wanted>& wanted, unsigned threads,
                         KeptSignatures* kept = nullptr);

}  // namespace host_sim::diagnose
