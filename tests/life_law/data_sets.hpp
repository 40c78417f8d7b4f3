#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::life_law::testing {

/// Specimens of one stress.
struct StressLevel {
  double stress;
  std::vector<double> failed;
  std::vector<double> suspended;
};

/// Levels are numbered in the order given.
LifeData life_data(const std::vector<StressLevel>& levels);

/// Times to breakdown (min) of an insulating fluid at 26 to 38 kV; Nelson (1972), "Graphical
/// analysis of accelerated life test data with the inverse power law model", IEEE Trans.
/// Reliability R-21, and Lawless (1982), "Statistical models and methods for lifetime data".
LifeData insulating_fluid();

/// Lives (1e6 revolutions) of rolling bearings at four loads; Nelson (1990), "Accelerated testing",
/// p. 305, without the outlier.
LifeData rolling_bearings();

/// Hours of motorettes at 170, 190 and 220 degrees Celsius, 13 of 30 suspended; Kalbfleisch and
/// Prentice (1980), "The statistical analysis of failure time data", p. 5. The stress is
/// exp(-1000 / (temperature + 273.2)), which makes Arrhenius' law a power law.
LifeData motorettes();

/// Kilocycles of 26 specimens of a superalloy under strain control, 4 suspended; Nelson (1990),
/// p. 272, and Meeker and Escobar (1998), "Statistical methods for reliability data", p. 439.
LifeData superalloy();

/// Hours of glass capacitors at 200 to 350 V and 170 degrees Celsius, half of them suspended; Zelen
/// (1959), Meeker and Escobar (1998), p. 447.
LifeData glass_capacitors();

/// The same with each life times `factor`.
LifeData scaled(LifeData data, double factor);

double sum_of_ln_failures(std::span<const LifeDatum> data);

inline constexpr LifeLaw kPaperLaw{.scale = 1.53e5, .exponent = 1.38, .shape = 5.94};

/// Four levels like the paper's (42.5 to 70.8 N) of `each` specimens with lives out of the law.
LifeData paper_like(std::uint64_t seed, std::size_t each = 20, const LifeLaw& law = kPaperLaw);

/// The same, and lives beyond `limit_cycles` are suspended there.
LifeData suspended_at(LifeData data, double limit_cycles);

/// Specimens in blocks of 40 to 80 N, `share` of the mean life each, until they fail or, every
/// third, after six blocks.
LifeData in_blocks(std::uint64_t seed, std::size_t count, double share,
                   const LifeLaw& law = kPaperLaw);

}  // namespace host_sim::life_law::testing
