#include "tests/support/paper_table.hpp"

#include <gtest/gtest.h>

namespace host_sim::testing {
namespace {

const std::vector<PaperRow> kRows{{"first (N)", {35.1, 99.4}, {35.164, 99.746}},
                                  {"second", {1740}, {1624.4}}};

std::vector<std::string> faults_of(const std::string& body) {
  return faults_of_paper_table(
      "# Title\n<!-- paper-table:begin -->\n"
      "| quantity | paper | ours | why |\n|---|---|---|---|\n" +
          body + "<!-- paper-table:end -->\n",
      "paper-table", kRows);
}

const std::string kFirst = "| first (N) | 35.1 99.4 | 35.16 99.75 | rounding |\n";
const std::string kSecond = "| second | 1.74e3 | 1.62e3 | alpha |\n";

TEST(PaperTable, ACorrectTableHasNoFaults) {
  EXPECT_TRUE(faults_of(kFirst + kSecond).empty());
  EXPECT_TRUE(faults_of(kSecond + "| first (N) | 35.1 99.4 | 35 99.7 | rounding |\n").empty());
}

TEST(PaperTable, EachKindOfFaultIsFound) {
  const std::vector<std::string> faulty{
      kFirst,
      kFirst + kSecond + kSecond,
      kFirst + kSecond + "| third | 1 | 1 | ? |\n",
      kFirst + "| second | 1.74e3 | 1.63e3 | alpha |\n",
      kFirst + "| second | 1.75e3 | 1.62e3 | alpha |\n",
      kFirst + "| second | 1.74e3 | 1624.6 | alpha |\n",
      kFirst + "| second | 1.74e3 | about 1.62e3 | alpha |\n",
      kFirst + "| second | 1.74e3 | nan | alpha |\n",
      kFirst + "| second | 1.74e3 | 1.62e3 |  |\n",
      kFirst + "| second | 1.74e3 | 1.62e3 |\n",
      kSecond + "| first (N) | 35.1 99.4 | 35.16 | rounding |\n",
      kSecond + "| first (N) | 35.1 99.4 | 35.16 99.75 1 | rounding |\n"};
  for (const std::string& body : faulty) {
    EXPECT_FALSE(faults_of(body).empty()) << body;
  }
  EXPECT_FALSE(faults_of_paper_table("no table here", "paper-table", kRows).empty());
}

}  // namespace
}  // namespace host_sim::testing
