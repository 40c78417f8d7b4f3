#include "firmware/app/config.hpp"

#include <gtest/gtest.h>

#include "rig.hpp"

namespace app {
namespace {

TEST(StoredParameters, TheLoadedBlockWinsOverTheConfiguredOne) {
  hal::fake::Clock clock;
  RamStore store(clock);
  const ParameterSet<2> configured{paper_parameters(1e5), paper_parameters(2e5)};
  ASSERT_EQ(store.save_parameters(1, lifemodel::encode(paper_parameters(3e5))), hal::Error::none);
  const auto set = stored_parameters<2>(store, configured);
  EXPECT_EQ(configuration_of(*set[0]), configuration_of(paper_parameters(1e5)));
  EXPECT_EQ(configuration_of(*set[1]), configuration_of(paper_parameters(3e5)));
}

TEST(StoredParameters, ADamagedBlockIsNotReplacedUnseen) {
  hal::fake::Clock clock;
  RamStore store(clock);
  auto block = lifemodel::encode(paper_parameters());
  block[20] ^= std::byte{1};
  ASSERT_EQ(store.save_parameters(0, block), hal::Error::none);
  EXPECT_FALSE(stored_parameters<1>(store, {paper_parameters()})[0].has_value());
}

}  // namespace
}  // namespace app
