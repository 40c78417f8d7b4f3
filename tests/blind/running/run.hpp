#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "tests/blind/making/make.hpp"
#include "tests/blind/scoring/record.hpp"

namespace blind {

/// The analysis: all that it is given is the campaign's folder.
using Analysis = std::function<host_sim::diagnose::Findings(
    const std::filesystem::path& folder, const host_sim::diagnose::DiagnoseOptions& options)>;

struct RunOptions {
  std::filesystem::path folder;      ///< where campaigns are made, each under its seed
  bool keep = false;                 ///< campaigns and truths, else removed when analysed
  bool oracle = true;                ///< whether to find out how visible the hidden effects are
  std::vector<std::string> without;  ///< effects that are taken out of the catalogue
  /// Told the seed and the digest of the sealed truth before the analysis begins.
  std::function<void(std::uint64_t seed, const std::string& sha256)> sealed;
};

/// Makes a campaign, seals what it hides outside of the campaign's folder, and has it analysed by
/// one thread.
/// @throws OutputError, Interruption
Record run_campaign(const Scenario& scenario, const Analysis& analysis, const RunOptions& options);

}  // namespace blind
