#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/design/study.hpp"

/// Designs with the paper's wire for the tests of their page.
namespace host_sim::samples {

struct DesignSample {
  std::string name;
  design::Study study;
  std::size_t charts;  ///< plots of its page
};

[[nodiscard]] const Model& design_model();

/// A varying load with a test, an endless life, a safety factor.
[[nodiscard]] std::vector<DesignSample> all_designs();

}  // namespace host_sim::samples
