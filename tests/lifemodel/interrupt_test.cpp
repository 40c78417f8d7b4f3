#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <memory>
#include <thread>

#include "support.hpp"

namespace lifemodel {
namespace {

struct Layout {
  static constexpr std::size_t kResidue = 128;
  static constexpr std::size_t kQueue = 1u << 18;
};

TEST(Interrupt, PushOnOneThreadSettleAndReadOnAnotherLosesNothing) {
  const Parameters p = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  const auto signal = lifemodel_test::white_noise(31, 200'000, 0, 100);
  auto shared = std::make_unique<Estimator<1, Layout>>(std::array{p});
  std::atomic<bool> done = false;
  std::thread producer([&] {
    for (const Tension sample : signal) {
      shared->push(0, sample);
    }
    done = true;
  });
  Damage before;
  while (!done) {
    shared->settle();
    const Reading now = shared->reading(0);
    EXPECT_LE(before, now.total);
    before = now.total;
  }
  producer.join();
  Estimator<1> alone({p});
  alone.replay(0, signal);
  EXPECT_EQ(shared->reading(0).total, alone.reading(0).total);
}

}  // namespace
}  // namespace lifemodel
