#include "tests/blind/making/make.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "hal/files/output_file.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "tests/blind/oracle/visibility.hpp"

namespace {

struct Arguments {
  std::uint64_t first_seed = blind::kFirstTuningSeed;
  std::size_t campaigns = 1;
  std::filesystem::path out;
  bool lives = false;
  unsigned threads = 0;
};

void write(const std::filesystem::path& path, const std::string& text) {
  hal::files::OutputFile file(path);
  file.write(text);
  file.commit();
}

/// Campaigns go into out/campaigns/<seed>, what they hide into out/truths/<seed>.json.
int run(const Arguments& arguments) {
  std::filesystem::create_directories(arguments.out / "truths");
  std::vector<std::string> lines(arguments.campaigns);
  const auto make = [&](std::size_t i) {
    const std::uint64_t seed = arguments.first_seed + i;
    const blind::Scenario scenario =
        arguments.lives ? blind::draw_visible_lives(seed) : blind::draw_recordings(seed);
    const std::string name = std::to_string(seed);
    const blind::Sealed sealed =
        blind::make_blind_campaign(scenario, arguments.out / "campaigns" / name);
    write(arguments.out / "truths" / (name + ".json"), sealed.text);
    lines[i] = fmt::format("{} {}\n", seed, sealed.sha256);
  };
  host_sim::statistics::parallel_for(arguments.campaigns, make, arguments.threads);
  for (const std::string& line : lines) {
    std::cout << line;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Makes campaigns that hide something, and beside them what they hide.");
  app.add_option("--first-seed", arguments.first_seed, "Below 10000 to tune with")
      ->capture_default_str();
  app.add_option("--campaigns", arguments.campaigns, "How many")->capture_default_str();
  app.add_option("--out", arguments.out, "Folder for both")->required();
  app.add_flag("--lives", arguments.lives, "Lives in place of recordings");
  app.add_option("--threads", arguments.threads, "0 is one for each core");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(arguments);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
