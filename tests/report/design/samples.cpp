#include "tests/report/design/samples.hpp"

#include "tests/design/paper_wire.hpp"

namespace host_sim::samples {

using design::Request;
using design::Tendon;
using design::Unknown;

const Model& design_model() {
  static const Model model = host_sim_test::paper_model();
  return model;
}

std::vector<DesignSample> all_designs() {
  const Model& model = design_model();
  const auto study = [&](const Request& request, const design::TestRequest& test) {
    return design::study(model, design::solve(model, request), test);
  };
  Tendon varying = host_sim_test::paper_tendon();
  varying.output_min_N = 24.5;
  Tendon straight = host_sim_test::paper_tendon();
  straight.bend_angle_deg = 0;
  return {
      {"typical",
       study({.unknown = Unknown::life, .tendon = varying, .load_ratio = {}}, {60.0, 300.0}), 3},
      {"endless", study({.unknown = Unknown::life, .tendon = straight, .load_ratio = {}}, {}), 2},
      {"safety",
       study({.unknown = Unknown::safety,
              .tendon = host_sim_test::paper_tendon(),
              .load_ratio = {},
              .life_cycles = 500},
             {}),
       3}};
}

}  // namespace host_sim::samples
