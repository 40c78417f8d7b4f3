// Writes what others need to know of the frame plan.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "firmware/generate/generate.hpp"
#include "hal/files/output_file.hpp"

namespace {

using protocol::Node;

/// CLI11 reads a std::uint8_t as a character.
std::vector<Node> checked_nodes(const std::vector<int>& numbers) {
  std::vector<Node> nodes;
  for (const int number : numbers) {
    const auto node = static_cast<Node>(number);
    if (std::find(nodes.begin(), nodes.end(), node) != nodes.end()) {
      throw CLI::ValidationError("--nodes", fmt::format("node {} is there twice", number));
    }
    nodes.push_back(node);
  }
  return nodes;
}

void write(const std::string& path, const std::string& text) {
  hal::files::OutputFile file{path};
  file.write(text);
  file.commit();
}

int run(int argc, char** argv) {
  CLI::App app{"Writes the frame plan for others", "protocol_generate"};
  app.require_subcommand(1);
  std::string out = "-";

  auto* const dbc = app.add_subcommand("dbc", "DBC file for third-party tools");
  std::vector<int> numbers;
  bool as_template = false;
  auto* const nodes = dbc->add_option("--nodes", numbers, "exact identifiers of these nodes")
                          ->delimiter(',')
                          ->check(CLI::Range(1, 127));
  auto* const one = dbc->add_flag("--template", as_template,
                                  "one node without its id, for identifiers masked with 0x780");
  nodes->excludes(one);
  auto* const javascript =
      app.add_subcommand("js", "ES module for browsers and Node.js: decode(id, data)");
  auto* const table =
      app.add_subcommand("table", "frame table of firmware/protocol/README.md in Markdown");
  auto* const services = app.add_subcommand(
      "services", "table of diagnostic services of firmware/protocol/README.md in Markdown");
  for (CLI::App* const verb : {dbc, javascript, table, services}) {
    verb->add_option("--out", out, "file to write, - for standard output")->capture_default_str();
  }

  try {
    app.parse(argc, argv);
    if (*dbc && numbers.empty() && !as_template) {
      throw CLI::RequiredError("--nodes or --template");
    }
    if (*dbc) {
      write(out, as_template ? protocol::generate::dbc_template()
                             : protocol::generate::dbc(checked_nodes(numbers)));
    } else if (*javascript) {
      write(out, protocol::generate::javascript());
    } else {
      write(out, *table ? protocol::generate::table() : protocol::generate::services());
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "protocol_generate: %s\n", error.what());
    return 1;
  }
}
