#include "tests/report/page/make_pages.hpp"

#include "host_sim/report/compare/html.hpp"
#include "tests/report/compare/samples.hpp"

int main(int argc, char** argv) {
  using namespace host_sim;
  return samples::make_pages(argc, argv, samples::all_comparisons(),
                             [](std::ostream& page, const auto& sample) {
                               write_compare_report(page, sample.comparison, "0.1.0");
                             });
}
