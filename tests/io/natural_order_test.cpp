#include "host_sim/io/natural_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using host_sim::compare_naturally;
using host_sim::naturally_before;

TEST(NaturalOrder, CountsAsPeopleDo) {
  const std::vector<std::string> sorted{
      "",   "0",     "01",     "1",   "2",
      "9a", "10",    "10a",    "10b", "100000000000000000000000000000000000000",
      "R2", "day-2", "day-10", "r02", "r2",
      "r10"};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      EXPECT_TRUE(compare_naturally(sorted[i], sorted[j]) == (i <=> j))
          << sorted[i] << ' ' << sorted[j];
    }
  }
}

TEST(NaturalOrder, KeepsWhatIsInOneFolderTogether) {
  const std::vector<std::string> sorted{"a/2.csv", "a/10.csv", "a-b/1.csv",
                                        "a.csv",   "b2/a.csv", "b10/a.csv"};
  EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end(), naturally_before));
  EXPECT_FALSE(naturally_before("a/2.csv", "a/2.csv"));
}

RC_GTEST_PROP(NaturalOrder, IsAnOrder, ()) {
  const auto before = [](const std::string& x, const std::string& y) {
    return compare_naturally(x, y) < 0;
  };
  const auto text = rc::gen::container<std::string>(rc::gen::element('0', '1', '2', 'a', '-'));
  const std::string a = *text;
  const std::string b = *text;
  const std::string c = *text;
  RC_ASSERT((before(a, b) || before(b, a)) == (a != b));
  RC_ASSERT(!(before(a, b) && before(b, a)));
  if (before(a, b) && before(b, c)) {
    RC_ASSERT(before(a, c));
  }
}

}  // namespace
