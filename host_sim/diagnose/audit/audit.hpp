#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/audit/gram.hpp"

namespace host_sim::diagnose {

/// What a campaign can show of one effect, before any response is used.
struct EffectAudit {
  enum class Verdict {
    visible,
    missing_channel,
    nothing_left,  ///< under kLeastShare once gain and friction are refitted
    too_weak,      ///< under kLeastSigmas even at the bounds of physics
  };
  const effects::TensionEffect* effect = nullptr;
  Verdict verdict = Verdict::visible;
  /// Root of the share of its energy that is left after the projection, for the case that the
  /// campaign shows best. 0 .. 1.
  double share = 0;
  double sigmas = 0;           ///< how many standard deviations the typical case makes
  double sigmas_at_bound = 0;  ///< the case shown best, as large as physics allows
  std::string prose;  ///< why it is invisible and what would show it; else how well it shows

  [[nodiscard]] bool visible() const { return verdict == Verdict::visible; }
};

/// How alike two visible effects are in this campaign: the typical case of each against all of the
/// other that physics makes visible, the worst one.
struct PairAudit {
  std::size_t first = 0, second = 0;  ///< indices in Audit::effects, first < second
  /// Root of the share of one case's energy that the other imitates with its parameters near its
  /// own; the smaller of both ways. |cos| of cases that a factor alone changes. Where one holds the
  /// other as a special case it alone can imitate, and this is small.
  double cosine = 0;
  std::string experiment;  ///< that distinguishes them
};

/// Effects that this campaign cannot distinguish: connected by pairs above kSameCosine.
struct EquivalenceClass {
  std::vector<std::size_t> members;      ///< indices in Audit::effects, rising; one or more
  std::vector<std::string> experiments;  ///< that break it, one for each such pair, without repeats
};

struct Audit {
  static constexpr double kLeastShare = 0.05;
  static constexpr double kLeastSigmas = 3;
  static constexpr double kSameCosine = 0.9;

  std::vector<EffectAudit> effects;       ///< in order of GramLayout::effects
  std::vector<PairAudit> pairs;           ///< of all visible effects
  std::vector<EquivalenceClass> classes;  ///< of all visible effects, by first member
  std::string prose;                      ///< the whole in sentences, for a report

  /// @throws std::out_of_range where there is no such effect
  [[nodiscard]] const EffectAudit& of(std::string_view id) const;
  /// Null where one of them is not visible.
  [[nodiscard]] const PairAudit* pair(std::string_view one, std::string_view other) const;
};

/// What a campaign can show and distinguish, from its design alone: what effects of usual size
/// would do to the input forces of its records.
/// @param threads 0: all cores
Audit audit(std::span<const effects::ForceRecord> records, double friction_coefficient,
            const NoiseModel& noise, unsigned threads);

/// The experiment that distinguishes two effects, as the catalogue has it from either side; a
/// crossed design where it names none.
std::string experiment_for(const effects::TensionEffect& one, const effects::TensionEffect& other);

/// The connected components of the visible effects, joined by pairs above Audit::kSameCosine.
std::vector<EquivalenceClass> classes_of(const std::vector<EffectAudit>& effects,
                                         const std::vector<PairAudit>& pairs);

}  // namespace host_sim::diagnose
