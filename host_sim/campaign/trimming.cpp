#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "hal/files/text.hpp"
#include "host_sim/campaign/campaign_files.hpp"

namespace host_sim {

using hal::files::in_quotes;

namespace {

using Status = Campaign::Status;

auto level_of(const Campaign::Specimen& specimen) {
  const Campaign::Load& load = specimen.blocks.front().load;
  return std::tuple(specimen.role, load.bend_angle_deg, load.input_tension_mean_N,
                    load.input_tension_amplitude_N);
}

/// The specimens of a level whose life was not dropped.
struct Kept {
  std::vector<double> lives;
  const Campaign::Specimen* found_broken = nullptr;
  const Campaign::Specimen* first_suspended = nullptr;

  void add(const Campaign::Specimen& specimen) {
    if (specimen.status == Status::failed) {
      lives.push_back(specimen.cycles());
    } else if (specimen.status != Status::suspended) {
      found_broken = &specimen;
    } else if (first_suspended == nullptr || specimen.cycles() < first_suspended->cycles()) {
      first_suspended = &specimen;
    }
  }
};

void refuse(const SpecimenRow& row, const Campaign::Specimen& other, std::string_view what,
            std::string_view accepted) {
  row.status_place.fail(fmt::format("specimen {} was trimmed, but {} of its level was {}",
                                    in_quotes(row.specimen.name), in_quotes(other.name), what),
                        accepted);
}

double kept_life(const SpecimenRow& row, const Kept& kept) {
  const bool low = row.specimen.status == Status::trimmed_low;
  if (kept.lives.empty()) {
    row.status_place.fail(fmt::format("specimen {} was trimmed, but no other of its level failed",
                                      in_quotes(row.specimen.name)),
                          "a level with specimens whose status is failed");
  }
  if (kept.found_broken != nullptr) {
    refuse(row, *kept.found_broken, "found broken at an inspection",
           "levels whose lives are all known, so that it is clear which were dropped");
  }
  const double life = low ? std::ranges::min(kept.lives) : std::ranges::max(kept.lives);
  if (kept.first_suspended != nullptr && !low) {
    refuse(row, *kept.first_suspended, "suspended, and may have lived longer",
           "trimmed_high in levels without suspended specimens");
  }
  if (kept.first_suspended != nullptr && kept.first_suspended->cycles() < life) {
    refuse(row, *kept.first_suspended,
           fmt::format("suspended at {} cycles, before the lowest life that was kept, {}",
                       kept.first_suspended->cycles(), life),
           "trimmed_low in levels without specimens suspended so early");
  }
  return life;
}

}  // namespace

void place_trimmed(std::span<SpecimenRow> rows) {
  std::map<decltype(level_of(rows.front().specimen)), Kept> levels;
  for (const SpecimenRow& row : rows) {
    if (row.specimen.constant_load() && !row.specimen.trimmed()) {
      levels[level_of(row.specimen)].add(row.specimen);
    }
  }
  for (SpecimenRow& row : rows) {
    if (row.specimen.trimmed()) {
      row.specimen.blocks.front().cycles = kept_life(row, levels[level_of(row.specimen)]);
    }
  }
}

}  // namespace host_sim
