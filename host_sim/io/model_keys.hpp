#pragma once

#include <span>
#include <string>
#include <string_view>

#include "host_sim/io/model.hpp"

namespace host_sim {

/// A number in `model.toml`: where it stands, what it may be, and where it goes.
struct ModelKey {
  std::string_view table;
  std::string_view key;
  std::string_view unit;  ///< the suffix of `key`, empty if it has none
  double minimum;
  double maximum;
  bool above_minimum;  ///< the minimum itself is not allowed
  double& (*value)(Model&);
};

/// All numbers of a model, grouped by table, in the order of the file format.
std::span<const ModelKey> model_keys();

/// The range of a key in words, e.g. `0.01..10`, `above 0 up to 1e+300`.
std::string range_text(const ModelKey& key);

}  // namespace host_sim
