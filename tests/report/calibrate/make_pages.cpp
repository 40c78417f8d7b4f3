#include "tests/report/page/make_pages.hpp"

#include "host_sim/report/calibrate/html.hpp"
#include "tests/report/calibrate/sample_result.hpp"

int main(int argc, char** argv) {
  using namespace host_sim;
  return samples::make_pages(argc, argv, samples::all_calibrations(),
                             [](std::ostream& page, const auto& sample) {
                               write_calibrate_report(page, sample.result, "0.1.0");
                             });
}
