#include "hal/fake/flash.hpp"
#include "tests/hal/contract/non_volatile.hpp"

namespace hal_test {
namespace {

template <class Flash>
class FakeFlash {
 public:
  Flash& memory() { return flash_; }
  bool tear(std::uint32_t address) {
    flash_.spoil(address);
    return true;
  }

 private:
  Flash flash_;
};

using Geometries =
    testing::Types<FakeFlash<hal::fake::Flash<>>, FakeFlash<hal::fake::Flash<2, 64, 16>>,
                   FakeFlash<hal::fake::Flash<3, 256, 4>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(FakeFlash, NonVolatileContract, Geometries);

}  // namespace
}  // namespace hal_test
