#pragma once

#include <span>
#include <string_view>

#include "host_sim/io/model.hpp"
#include "host_sim/io/number_range.hpp"

namespace host_sim {

/// A number in `model.toml`: where it stands, what it may be, and where it goes.
struct ModelKey {
  std::string_view table;
  std::string_view key;
  std::string_view unit;  ///< the suffix of `key`, empty if it has none
  NumberRange range;
  double& (*value)(Model&);
};

/// All numbers of a model, grouped by table, in the order of the file format.
std::span<const ModelKey> model_keys();

}  // namespace host_sim
