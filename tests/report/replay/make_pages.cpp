#include "tests/report/page/make_pages.hpp"

#include "host_sim/report/replay/html.hpp"
#include "tests/report/replay/samples.hpp"

int main(int argc, char** argv) {
  using namespace host_sim;
  return samples::make_pages(
      argc, argv, samples::all(),
      [](std::ostream& page, const auto& sample) { write_replay_report(page, sample.report); });
}
