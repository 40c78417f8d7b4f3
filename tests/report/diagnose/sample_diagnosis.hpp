#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"

/// Diagnoses made by hand: what is in them is plausible, not computed.
namespace host_sim::samples {

struct DiagnosisSample {
  std::string name;
  std::size_t charts = 0;  ///< plots that the page has to draw
  std::string campaign;
  diagnose::Diagnosis diagnosis;
};

/// Wear of the sheath is named with 0.987: six sessions, residuals over two covariates, one of them
/// mended; a warning, two invisible effects and one pair that cannot be distinguished.
[[nodiscard]] diagnose::Diagnosis wear_named();

/// Nothing is wrong: six sessions, no extension.
[[nodiscard]] diagnose::Diagnosis nothing_wrong();

/// An effect that the catalogue lacks is named; 12 % of the squared error remain.
[[nodiscard]] diagnose::Diagnosis outside_of_catalogue();

/// Gear asymmetry or an error of the bend angle.
[[nodiscard]] diagnose::Diagnosis ambiguous_pair();

/// Structure that nothing explains.
[[nodiscard]] diagnose::Diagnosis unexplained();

/// Two effects of the catalogue explain a part of it.
[[nodiscard]] diagnose::Diagnosis explained_in_part();

/// Lives of three lots at four levels whose scatter between lots is named.
[[nodiscard]] diagnose::Diagnosis lots_named();

/// Recordings and lives, both named.
[[nodiscard]] diagnose::Diagnosis both_named();

/// Names and sentences that try to leave the place they are put in.
[[nodiscard]] diagnose::Diagnosis hostile_diagnosis();

/// Pages of each verdict and at the edges of what a diagnosis can hold.
[[nodiscard]] std::vector<DiagnosisSample> all_diagnoses();

}  // namespace host_sim::samples
