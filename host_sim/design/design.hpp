#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "host_sim/model/model.hpp"
#include "host_sim/reference/equations.hpp"

/// What a tendon, its sheath and its load have to be for a life that is wanted at a risk.
namespace host_sim::design {

/// A tendon in its sheath under its load. The wire has the material and the construction of that of
/// the model: its strength grows with the square of its diameter, and wires live equally long at
/// equal stress.
struct Tendon {
  double bend_angle_deg;        ///< phi of (14), summed over the whole path, 0 .. 1800
  double friction_coefficient;  ///< mu of (14), 0 .. 1
  double output_max_N;          ///< tension at the far end of the sheath over a cycle, above 0
  double output_min_N;          ///< 0 .. output_max_N
  double diameter_mm;           ///< above 0

  /// Lowest tension over the highest.
  [[nodiscard]] double load_ratio() const { return output_min_N / output_max_N; }
};

/// What a load does to the wire at the input of the sheath, where it breaks.
struct Stress {
  double efficiency;               ///< (14)
  reference::MeanAmplitude input;  ///< (12), (13)
  double ultimate_tension_N;
  double effective_tension_N;         ///< (11)
  double characteristic_life_cycles;  ///< (19) at this stress; infinite where nothing varies

  [[nodiscard]] double peak_N() const { return input.mean_N + input.amplitude_N; }
  /// The wire is torn by the first cycle: what the life law says of it means nothing.
  [[nodiscard]] bool breaks_at_once() const { return peak_N() >= ultimate_tension_N; }
};

[[nodiscard]] Stress stress_of(const Model& model, const Tendon& tendon);

/// The effective tension that does as much to the wire of the model, which the law is of.
[[nodiscard]] double law_tension_N(const Model& model, const Stress& stress);

/// The life in cycles that a share of the wires does not reach, (22).
/// @param risk above 0, below 1
[[nodiscard]] double life_at(const Model& model, const Tendon& tendon, double risk);

/// Diameter of the wire of this strength. @param ultimate_tension_N above 0
[[nodiscard]] double diameter_of(const Model& model, double ultimate_tension_N);

/// What is solved for. Safety: nothing is, and the factors say how far the tendon is from its
/// limits.
enum class Unknown { life, tension, bend, friction, wire, risk, safety };

/// The names of all, in order.
[[nodiscard]] std::span<const std::string_view> unknown_names();

/// What is given. The place of the unknown is not read.
struct Request {
  Unknown unknown = Unknown::life;
  Tendon tendon{};
  /// Where the tension is unknown: its lowest value goes with the highest by this ratio, or without
  /// it stays that of the tendon.
  std::optional<double> load_ratio;
  double life_cycles = 0;
  double risk = 0.1;
};

/// All that was given with what was found. Of safety `life_cycles` is the life that is wanted.
struct Design {
  Unknown found;
  Tendon tendon;
  double life_cycles;
  double risk;
};

/// As far as is looked for the unknown.
inline constexpr double kMostBend_deg = 1800;
inline constexpr double kLeastTension_N = 0.01;
inline constexpr double kThickestWire_mm = 200;

/// Solves for the unknown: life, risk, tension and wire in closed form, bend and friction by a
/// bracketed root.
/// @throws InputError where no value of the unknown in its range gives the wanted life, or where
/// the wire is torn at once
[[nodiscard]] Design solve(const Model& model, const Request& request);

}  // namespace host_sim::design
