#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/blind/running/run.hpp"
#include "tests/blind/scoring/proportion.hpp"

namespace blind {

/// Runs campaigns of these scenarios on all cores and prints a line of each.
/// @return records in the order of the scenarios
std::vector<Record> run_sample(const std::vector<Scenario>& scenarios, const Analysis& analysis,
                               const std::vector<std::string>& without = {});

/// The first scenarios to score with.
std::vector<Scenario> first_scenarios(Scenario (*draw)(std::uint64_t seed), std::size_t count);

/// What every answer to a sample must keep: no name where nothing is hidden, every name right, and
/// the truth first as often as many campaigns have had it; see Proportion::least_of().
void expect_good(const std::vector<Record>& records, const Proportion& right_of_many);

/// Without the effect in the catalogue nothing is named instead in its campaigns, and they are
/// unknown where an oracle sees the effect at so many standard deviations: of each effect campaigns
/// are tried until one is as plain as that.
/// @param draft gives kind, design and effects of a seed as `draw` does, sooner
void expect_unknown_without(Scenario (*draft)(std::uint64_t seed),
                            Scenario (*draw)(std::uint64_t seed), const Analysis& analysis,
                            const std::vector<std::string>& ids, double plain_sigmas);

}  // namespace blind
