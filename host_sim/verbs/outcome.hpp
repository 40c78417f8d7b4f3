#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/output_file.hpp"
#include "host_sim/batch/run_batch.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace host_sim {

/// The option `--fail-on` with `names`, several of them behind commas, or `any`.
CLI::Option* add_fail_on(CLI::App& verb, std::vector<std::string>& fail_on,
                         std::vector<std::string> names, const std::string& description);

/// Whether one of `found` is one to fail on.
bool fails_on(const std::vector<std::string>& fail_on, const std::vector<std::string>& found);

/// The outputs of a batch: a table with a row and a JSON file with an object for each piece.
struct BatchOutputs {
  std::optional<hal::files::OutputFile> table;
  std::optional<hal::files::OutputFile> json;

  /// Opens those whose path is not empty. @throws OutputError
  void open(const std::string& table_path, const std::string& json_path);

  /// Writes both and puts them in place.
  /// @param head header line of the table
  /// @param key of the array in the JSON file
  /// @throws OutputError
  void write(std::string_view head, std::string_view key,
             const std::vector<batch::Answer>& answers);
};

/// Reports the errors on standard error, each line once. @return how many answers are errors
std::size_t report_errors(const std::vector<batch::Answer>& answers);

/// The exit status: 1 where a piece was refused, else kFoundInData where an answer has found what
/// `--fail-on` asks for.
int status_of(const std::vector<batch::Answer>& answers, const std::vector<std::string>& fail_on);

}  // namespace host_sim
