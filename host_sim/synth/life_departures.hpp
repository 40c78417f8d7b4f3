#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "host_sim/reference/equations.hpp"
#include "host_sim/synth/values.hpp"

namespace host_sim::synth {

/// A constant load of a life test, as its operator sets it.
struct LifeLoad {
  double bend_angle_deg = 0;
  double output_mean_N = 0;
  double output_amplitude_N = 0;
  double frequency_Hz = 1;
  double wire_to_bend_ratio = 0;  ///< d / D; 0 where it is not known
};

/// Which specimen it is, from 0, and where it came from and ran.
struct SpecimenPlace {
  std::size_t number = 0;
  std::size_t lot = 0;
  std::size_t rig = 0;
};

/// One departure of lives from the nominal model, with what it draws for one specimen. What a part
/// does not override stays.
class LifePart {
 public:
  LifePart() = default;
  LifePart(const LifePart&) = delete;
  LifePart& operator=(const LifePart&) = delete;
  virtual ~LifePart() = default;

  /// A specimen is put in; all that is random comes from the seed and the specimen's place.
  virtual void begin(const SpecimenPlace& /*place*/, std::uint64_t /*seed*/) {}

  /// The tension that really acts at the output.
  [[nodiscard]] virtual reference::MeanAmplitude output_N(reference::MeanAmplitude output) const {
    return output;
  }
  /// Input tension with what bending adds.
  [[nodiscard]] virtual reference::MeanAmplitude input_N(reference::MeanAmplitude input,
                                                         const LifeLoad& /*load*/) const {
    return input;
  }
  /// The fully reversed tension that does the same damage.
  [[nodiscard]] virtual double effective_tension_N(double effective_N,
                                                   reference::MeanAmplitude /*input*/,
                                                   double /*ultimate_tension_N*/) const {
    return effective_N;
  }
  /// The part of it that does damage, for the inverse power law; at most 0 for none.
  [[nodiscard]] virtual double damaging_tension_N(double effective_N) const { return effective_N; }

  /// Factor on the life of this specimen.
  [[nodiscard]] virtual double life_factor() const { return 1; }

  /// Life of this specimen if it could fail by another mode alone.
  [[nodiscard]] virtual double other_life_cycles(double /*effective_N*/) const {
    return std::numeric_limits<double>::infinity();
  }
  /// Exponent q of Manson and Halford's rule; 0 is Miner's.
  [[nodiscard]] virtual double sequence_exponent() const { return 0; }

  /// Rate at which damage for each cycle grows with calendar time.
  [[nodiscard]] virtual double ageing_1_day() const { return 0; }
};

/// A part that a plan may ask for by name.
struct LifeKind {
  std::string_view id;
  std::vector<Parameter> parameters;
  std::vector<Choice> choices;
  std::unique_ptr<LifePart> (*make)(const Values& values);
};

template <class Part>
std::unique_ptr<LifePart> make_life_part(const Values& values) {
  return std::make_unique<Part>(values);
}

/// The effects of the catalogue that lives may show, in order of its table.
std::span<const LifeKind> life_kinds();

/// Departures that the catalogue does not have.
std::span<const LifeKind> outside_life_kinds();

}  // namespace host_sim::synth
