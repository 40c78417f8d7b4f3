#pragma once

#include <cstddef>
#include <string>

namespace blind {

/// How many of some campaigns something holds for.
struct Proportion {
  std::size_t holds = 0;
  std::size_t of = 0;

  void add(bool one) {
    holds += one ? 1 : 0;
    ++of;
  }
  /// NaN of none.
  [[nodiscard]] double value() const;

  /// Bounds of 95 % together, by Clopper and Pearson, The use of confidence or fiducial limits
  /// illustrated in the case of the binomial, Biometrika 26, 1934. 0 and 1 of none.
  [[nodiscard]] double lower() const;
  [[nodiscard]] double upper() const;

  /// What `some` campaigns have to reach at least: fewer come out of them in one draw of ten at
  /// most, where each holds with this proportion.
  [[nodiscard]] std::size_t least_of(std::size_t some) const;
};

/// "96.0 % (93.1 .. 97.9, 288 of 300)", or "-" of none.
std::string text_of(const Proportion& proportion);

}  // namespace blind
