// Random calls, faults, cuts and rot of a flash store against a plain model.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <vector>

#include "hal/fake/flash.hpp"
#include "tests/storage/model.hpp"
#include "tests/storage/rig.hpp"

namespace storage_test {
namespace {

using hal::Error;
using hal::fake::FlashFault;

enum class ActionKind : std::uint8_t { save, load, append, prepare, restart, fault };

struct Action {
  ActionKind kind;
  FlashFault fault;
  std::uint32_t after;  ///< operations until the fault
};

rc::Gen<Action> action() {
  const auto kind = rc::gen::weightedElement<ActionKind>({{12, ActionKind::save},
                                                          {4, ActionKind::load},
                                                          {2, ActionKind::append},
                                                          {4, ActionKind::prepare},
                                                          {2, ActionKind::restart},
                                                          {6, ActionKind::fault}});
  const auto fault = rc::gen::build<FlashFault>(
      rc::gen::set(&FlashFault::kind,
                   rc::gen::element(FlashFault::Kind::cut_before, FlashFault::Kind::cut_torn,
                                    FlashFault::Kind::cut_half, FlashFault::Kind::cut_after,
                                    FlashFault::Kind::refuse, FlashFault::Kind::lose)),
      rc::gen::set(&FlashFault::seed));
  return rc::gen::build<Action>(rc::gen::set(&Action::kind, kind),
                                rc::gen::set(&Action::fault, fault),
                                rc::gen::set(&Action::after, rc::gen::inRange(0u, 40u)));
}

template <std::size_t kTendons>
void lives_through(const std::vector<Action>& actions) {
  using Tested = StoreOn<Small, kTendons>;
  Small::Flash flash;
  Socket<Small::Flash> socket(flash);
  Tested store(socket);
  Model<kTendons> model;
  std::uint32_t step = 0;
  RC_ASSERT(model.save(store, step) == Error::none);
  for (const Action& action : actions) {
    ++step;
    switch (action.kind) {
      case ActionKind::save:
        (void)model.save(store, step);
        break;
      case ActionKind::load:
        (void)model.load(store, step);
        break;
      case ActionKind::append:
        (void)model.append(store, step);
        break;
      case ActionKind::prepare:
        (void)store.prepare();
        break;
      case ActionKind::fault:
        flash.fault(flash.operations() + action.after, action.fault);
        break;
      case ActionKind::restart:
        flash.power_on();
        break;
    }
    // A call that did not end is known to the model only until the next of its kind.
    if (!flash.powered() || model.saving || model.loading || model.appending ||
        action.kind == ActionKind::restart) {
      flash.power_on();
      store = Tested(socket);
      model.check(store);
      RC_ASSERT(!testing::Test::HasFatalFailure());
    }
  }
  flash.power_on();
  RC_ASSERT(model.save(store, step + 1) == Error::none);
  Tested last(socket);
  model.check(last);
  RC_ASSERT(!testing::Test::HasFatalFailure());
}

void check(void (*lives)(const std::vector<Action>&)) {
  EXPECT_TRUE(rc::check([lives] {
    const auto actions =
        *rc::gen::container<std::vector<Action>>(*rc::gen::inRange<std::size_t>(0, 300), action());
    lives(actions);
  }));
}

TEST(FlashProperty, OneTendon) {
  check(lives_through<1>);
}
TEST(FlashProperty, TwoTendons) {
  check(lives_through<2>);
}
TEST(FlashProperty, FourTendons) {
  check(lives_through<4>);
}

// A unit that rots takes its record along and nothing else: what is found was committed once.
TEST(FlashProperty, RotIsNeverTakenForARecord) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint32_t>& rot) {
    Small::Flash flash;
    Socket<Small::Flash> socket(flash);
    StoreOn<Small, 2> store(socket);
    constexpr std::uint32_t kSaves = 55;
    for (std::uint32_t step = 0; step < kSaves; ++step) {
      RC_ASSERT(store.save(records_of<2>(step)) == Error::none);
    }
    for (const std::uint32_t where : rot) {
      const std::uint32_t at = where / 16 % (4 * 880);
      where % 2 == 0 ? flash.spoil(at) : flash.flip(at, where / 2 % 8);
    }
    StoreOn<Small, 2> next(socket);
    const bool any = next.load(0) || next.load(1);
    for (std::size_t tendon = 0; tendon < 2; ++tendon) {
      const auto found = next.load(tendon);
      RC_ASSERT(found || next.past_lost());
      RC_ASSERT(!found || same_life(*found, record_of(tendon, found->sequence - 1)));
    }
    RC_ASSERT(next.save(records_of<2>(kSaves)) == Error::none);
    RC_ASSERT(!any || next.sequence() > store.sequence());
  }));
}

}  // namespace
}  // namespace storage_test
