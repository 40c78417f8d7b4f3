#include "tests/report/page/make_pages.hpp"

#include "host_sim/report/plan/html.hpp"
#include "tests/report/plan/samples.hpp"

int main(int argc, char** argv) {
  using namespace host_sim;
  return samples::make_pages(
      argc, argv, samples::all_plans(), [](std::ostream& page, const auto& sample) {
        write_plan_report(page, sample.request, sample.result, sample.courses, "0.1.0");
      });
}
