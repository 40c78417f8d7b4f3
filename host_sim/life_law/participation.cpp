#include "host_sim/life_law/participation.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::life_law {
namespace {

std::size_t levels_in(std::span<const LifeDatum> data) {
  std::size_t levels = 0;
  for (const LifeDatum& datum : data) {
    if (datum.level != LifeDatum::kNoLevel) {
      levels = std::max(levels, datum.level + 1);
    }
  }
  return levels;
}

}  // namespace

bool has_levels(LifeForm form) {
  return form.scale == LifeForm::Scale::free || form.shape == LifeForm::Shape::free;
}

Participation::Participation(std::span<const LifeDatum> data, LifeForm form)
    : by_level_(has_levels(form)) {
  std::vector<bool> part(levels_in(data), form.scale != LifeForm::Scale::free);
  for (const LifeDatum& datum : data) {
    if (datum.level != LifeDatum::kNoLevel && datum.failed) {
      part[datum.level] = true;
    }
  }
  number(part);
}

Participation::Participation(const LifeFit& fit) : by_level_(has_levels(fit.form)) {
  std::vector<bool> part;
  if (fit.form.scale == LifeForm::Scale::free) {
    for (const double ln_scale : fit.scale) {
      part.push_back(std::isfinite(ln_scale));
    }
  } else if (by_level_) {
    part.assign(fit.shape.size(), true);
  }
  number(part);
}

void Participation::number(const std::vector<bool>& part) {
  for (const bool takes : part) {
    columns_of_levels_.push_back(takes ? columns_++ : LifeDatum::kNoLevel);
  }
}

bool Participation::takes_part(const LifeDatum& datum) const {
  if (!by_level_) {
    return true;
  }
  return datum.level < columns_of_levels_.size() &&
         columns_of_levels_[datum.level] != LifeDatum::kNoLevel;
}

}  // namespace host_sim::life_law
