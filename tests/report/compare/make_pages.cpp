// make_pages FOLDER: writes one page for each sample and `charts.txt`, a line "NAME CHARTS" each.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "host_sim/report/compare/html.hpp"
#include "tests/report/compare/samples.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_pages FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  std::ofstream charts(folder / "charts.txt");
  for (const host_sim::samples::ComparisonSample& sample : host_sim::samples::all_comparisons()) {
    std::ofstream page(folder / (sample.name + ".html"), std::ios::binary);
    host_sim::write_compare_report(page, sample.comparison, "0.1.0");
    charts << sample.name << ' ' << sample.charts << '\n';
    if (!page.flush()) {
      std::cerr << "make_pages: cannot write " << sample.name << '\n';
      return 1;
    }
  }
  return charts.flush() ? 0 : 1;
}
