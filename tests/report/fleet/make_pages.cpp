#include "tests/report/page/make_pages.hpp"

#include <vector>

#include "host_sim/report/fleet/html.hpp"
#include "tests/report/fleet/samples.hpp"

int main(int argc, char** argv) {
  using namespace host_sim;
  return samples::make_pages(argc, argv,
                             std::vector{samples::typical_fleet(), samples::idle_fleet()},
                             [](std::ostream& page, const auto& sample) {
                               write_fleet_report(page, "t.csv", sample.fleet, sample.request,
                                                  sample.plan, sample.course, "0.1.0");
                             });
}
