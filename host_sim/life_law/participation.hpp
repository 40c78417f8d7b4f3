#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::life_law {

/// Which specimens take part in a form. Forms with free levels take only specimens that have a
/// level; where the scales are free, a level without failures takes no part: its scale is infinite
/// and its likelihood one.
class Participation {
 public:
  Participation(std::span<const LifeDatum> data, LifeForm form);
  /// That of a fit that was made before.
  explicit Participation(const LifeFit& fit);

  [[nodiscard]] bool takes_part(const LifeDatum& datum) const;

  /// Number of levels, those without a part included.
  [[nodiscard]] std::size_t levels() const { return columns_of_levels_.size(); }
  /// Number of levels that take part.
  [[nodiscard]] std::size_t columns() const { return columns_; }
  /// Place of a level among those that take part, or LifeDatum::kNoLevel.
  [[nodiscard]] std::size_t column(std::size_t level) const { return columns_of_levels_[level]; }

 private:
  void number(const std::vector<bool>& part);

  bool by_level_;
  std::vector<std::size_t> columns_of_levels_;
  std::size_t columns_ = 0;
};

/// Whether a form has a coefficient for each level.
bool has_levels(LifeForm form);

}  // namespace host_sim::life_law
