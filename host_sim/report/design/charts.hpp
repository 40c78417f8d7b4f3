#pragma once

#include <vector>

#include "host_sim/design/study.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/report/page/chart.hpp"

/// The plots of the page of a design. A chart without anything to show has no layers.
namespace host_sim::design_page {

/// Life at the risk over output tension at several bend angles, with the design marked.
[[nodiscard]] Chart life_chart(const design::Study& study);

/// Effective tension over the bend angle under the load, under a constant one and under one from
/// zero: Fig. 5 of the paper with the efficiency as the angle that causes it.
[[nodiscard]] Chart stress_chart(const Model& model, const design::Study& study);

/// The acceleration factor of tests at higher tensions, section 3.1.
[[nodiscard]] Chart acceleration_chart(const Model& model, const design::Study& study);

/// All of the above that have something to show, in the order of the page.
[[nodiscard]] std::vector<Chart> charts(const Model& model, const design::Study& study);

}  // namespace host_sim::design_page
