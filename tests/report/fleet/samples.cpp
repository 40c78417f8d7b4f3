#include "tests/report/fleet/samples.hpp"

#include <utility>

#include "host_sim/fleet/costs.hpp"

namespace host_sim::samples {
namespace {

using namespace host_sim::fleet;

FleetSample planned(std::string name, Fleet fleet, Horizon horizon) {
  Model::Life life{};
  life.weibull_shape = 5.94;
  fleet.models = {{"model.toml", Model{{}, {}, {}, {}, life}}};
  const PlanRequest request{.today = parse_date("2026-03-02").value(),
                            .horizon = std::move(horizon)};
  FleetPlan plan = make_plan(fleet, request);
  std::vector<SparesUntil> course = course_of(fleet, request, plan);
  return {std::move(name), std::move(fleet), request, std::move(plan), std::move(course)};
}

}  // namespace

FleetSample typical_fleet() {
  Fleet fleet;
  const auto add = [&](const char* name, double damage) {
    fleet.tendons.push_back(
        {.name = name, .damage = damage, .damage_per_h = 1e-3, .hours_per_day = 10});
  };
  add("young", 0.1);
  add("old", 0.68464);
  add("<b>&", 0.5);
  fleet.broken = {"r1/3/<i>"};
  set_costs(fleet, 100, 1000, "t.csv");
  return planned("typical", std::move(fleet), {Horizon::Kind::calendar, 10, "10d"});
}

FleetSample idle_fleet() {
  Fleet fleet;
  fleet.tendons = {{.name = "idle"}};
  return planned("idle", std::move(fleet), {Horizon::Kind::operation, 2000, "2000h"});
}

}  // namespace host_sim::samples
