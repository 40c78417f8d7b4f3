#include "tests/statistics/survreg.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace host_sim::survreg {
namespace {

/// A CSV file of the rows that is there as long as this is.
class LivesFile {
 public:
  explicit LivesFile(std::span<const Row> rows)
      : path_(std::filesystem::temp_directory_path() /
              ("survreg_lives_" + std::to_string(::getpid()) + ".csv")) {
    std::ofstream file(path_);
    file << std::setprecision(std::numeric_limits<double>::max_digits10) << "life,failed,x\n";
    for (const Row& row : rows) {
      file << row.life << ',' << row.failed << ',' << row.x << '\n';
    }
  }
  LivesFile(const LivesFile&) = delete;
  LivesFile& operator=(const LivesFile&) = delete;
  ~LivesFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  [[nodiscard]] std::string name() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

std::string output_of(const std::string& command) {
  const auto close = [](std::FILE* pipe) { ::pclose(pipe); };
  const std::unique_ptr<std::FILE, decltype(close)> pipe(::popen(command.c_str(), "r"), close);
  if (!pipe) {
    throw std::runtime_error("cannot run " + command);
  }
  std::string output;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr) {
    output += part.data();
  }
  return output;
}

Fit read_fit(const std::string& line) {
  std::istringstream words(line);
  Fit result;
  words >> result.log_likelihood >> result.scale;
  for (double coefficient = 0; words >> coefficient;) {
    result.coefficients.push_back(coefficient);
  }
  return result;
}

/// The fits with each of `formulas` (with ; between them) and each distribution.
std::vector<Fit> fits_of(std::span<const Row> rows, const std::string& formulas,
                         std::span<const std::string> distributions, std::size_t expected) {
  const LivesFile lives(rows);
  std::string command = "Rscript '" SURVREG_SCRIPT "' '" + lives.name() + "' '" + formulas + "'";
  for (const std::string& distribution : distributions) {
    command += " '" + distribution + "'";
  }
  std::istringstream lines(output_of(command));
  std::vector<Fit> fits;
  for (std::string line; std::getline(lines, line);) {
    fits.push_back(read_fit(line));
  }
  if (fits.size() != expected) {
    throw std::runtime_error("no answer from: " + command);
  }
  return fits;
}

}  // namespace

bool available() {
  return std::system(
             "Rscript -e 'quit(status = !nzchar(system.file(package = \"survival\")))'"
             " > /dev/null 2>&1") == 0;
}

std::vector<Fit> fit(std::span<const Row> rows, const std::string& formula,
                     std::span<const std::string> distributions) {
  return fits_of(rows, formula, distributions, distributions.size());
}

std::vector<Fit> fit_weibull(std::span<const Row> rows, std::span<const std::string> formulas) {
  std::string joined;
  for (const std::string& formula : formulas) {
    joined += (joined.empty() ? "" : ";") + formula;
  }
  return fits_of(rows, joined, std::array{std::string("weibull")}, formulas.size());
}

}  // namespace host_sim::survreg
