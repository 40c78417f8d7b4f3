#pragma once

#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/tension/hypothesis.hpp"

namespace host_sim::diagnose {

/// The parameters of one part of a model with their 95 % intervals, as the catalogue names them;
/// one for each pose where the part has a column for each, "..._at_90_deg". A shape's interval is
/// where the evidence of the whole model is within what a chi-square of one degree of freedom
/// leaves, times `dispersion`; a size's holds what it is at the ends of those of its shape.
/// @param part its place in `model`
std::vector<Estimate> estimates_of(const Evidence& evidence, std::span<const Component> model,
                                   std::size_t part, double dispersion);

/// The same as values to write into a model, within the bounds of the catalogue.
Extension extension_of(const Component& part, const std::vector<Estimate>& estimates,
                       const effects::Baseline& baseline);

}  // namespace host_sim::diagnose
