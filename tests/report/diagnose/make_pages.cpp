#include "tests/report/page/make_pages.hpp"

#include "host_sim/report/diagnose/html.hpp"
#include "tests/report/diagnose/sample_diagnosis.hpp"

int main(int argc, char** argv) {
  using namespace host_sim;
  return samples::make_pages(
      argc, argv, samples::all_diagnoses(), [](std::ostream& page, const auto& sample) {
        write_diagnose_report(page, sample.campaign, sample.diagnosis, "0.1.0");
      });
}
