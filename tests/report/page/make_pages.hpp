#pragma once

#include <filesystem>
#include <fstream>
#include <iostream>

namespace host_sim::samples {

/// make_pages FOLDER: writes one page for each sample and `charts.txt`, a line "NAME CHARTS" each.
/// @param samples with name and charts
/// @param write page(stream, sample)
/// @returns the status of the program
template <class Samples, class Write>
int make_pages(int argc, char** argv, const Samples& samples, Write write) {
  if (argc != 2) {
    std::cerr << "usage: make_pages FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  std::ofstream charts(folder / "charts.txt");
  for (const auto& sample : samples) {
    std::ofstream page(folder / (sample.name + ".html"), std::ios::binary);
    write(page, sample);
    charts << sample.name << ' ' << sample.charts << '\n';
    if (!page.flush()) {
      std::cerr << "make_pages: cannot write " << sample.name << '\n';
      return 1;
    }
  }
  return charts.flush() ? 0 : 1;
}

}  // namespace host_sim::samples
