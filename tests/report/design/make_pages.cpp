#include "tests/report/page/make_pages.hpp"

#include "host_sim/report/design/html.hpp"
#include "tests/report/design/samples.hpp"

int main(int argc, char** argv) {
  using namespace host_sim;
  return samples::make_pages(
      argc, argv, samples::all_designs(), [](std::ostream& page, const auto& sample) {
        write_design_report(page, samples::design_model(), sample.study, {"5ed12218", {}}, "0.1.0");
      });
}
