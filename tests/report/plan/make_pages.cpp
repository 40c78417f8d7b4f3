// make_pages FOLDER: writes one page for each sample and `charts.txt`, a line "NAME CHARTS" each.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "host_sim/report/plan/html.hpp"
#include "tests/report/plan/samples.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_pages FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  std::ofstream charts(folder / "charts.txt");
  for (const host_sim::samples::PlanSample& sample : host_sim::samples::all_plans()) {
    std::ofstream page(folder / (sample.name + ".html"), std::ios::binary);
    host_sim::write_plan_report(page, sample.request, sample.result, sample.courses, "0.1.0");
    charts << sample.name << ' ' << sample.charts << '\n';
    if (!page.flush()) {
      std::cerr << "make_pages: cannot write " << sample.name << '\n';
      return 1;
    }
  }
  return charts.flush() ? 0 : 1;
}
