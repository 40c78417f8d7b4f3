#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace host_sim::proof {

/// Expects p-values that are each one of 1 / (replicates + 1), 2 / (replicates + 1) .. 1 to be
/// uniform: the largest distance of their distribution from the diagonal is below what one sample
/// in a thousand exceeds (1.95 / sqrt(n), Kolmogorov) and a step of theirs, and at most 5 % within
/// 3 binomial errors are at or below 0.05. Prints both figures.
void expect_uniform(const std::string& what, std::vector<double> p, std::size_t replicates);

}  // namespace host_sim::proof
