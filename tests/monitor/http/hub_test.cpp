#include "host_sim/monitor/http/hub.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "tests/monitor/http/made_view.hpp"

namespace host_sim::monitor {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
constexpr milliseconds kPatience{10'000};

/// Offers until it is taken.
void offer_until_taken(Hub& hub, const FleetView& view) {
  for (;;) {
    hub.offer(view);
    const auto taken = hub.view();
    if (taken && taken->now_ns == view.now_ns) {
      return;
    }
    std::this_thread::sleep_for(milliseconds(5));
  }
}

TEST(Hub, HasNothingToSayBeforeTheFirstView) {
  Hub hub;
  hub.join();
  EXPECT_EQ(hub.view(), nullptr);
  EXPECT_EQ(hub.next(0, milliseconds(1)).json, nullptr);
}

TEST(Hub, GivesAWholeViewThenChanges) {
  Hub hub;
  hub.join();
  FleetView view = test::made_view();
  offer_until_taken(hub, view);
  const Hub::Message first = hub.next(0, kPatience);
  ASSERT_TRUE(first.json);
  EXPECT_TRUE(first.whole);
  EXPECT_EQ(json::parse(*first.json)["frames"], 42);
  EXPECT_EQ(hub.next(first.version, milliseconds(1)).json, nullptr);

  view.now_ns += 1'000'000;
  view.frames = 43;
  view.nodes[5].events.push_back({EventKind::boot, 1, "boot", protocol::LifeState::inspect});
  offer_until_taken(hub, view);
  const Hub::Message second = hub.next(first.version, kPatience);
  ASSERT_TRUE(second.json);
  EXPECT_FALSE(second.whole);
  const json change = json::parse(*second.json);
  EXPECT_EQ(change["patch"], json::parse(R"({"now_us": 10001000, "frames": 43})"));
  EXPECT_EQ(change["events"]["5"].size(), 1u);
  EXPECT_EQ(change["events"]["5"][0]["words"], "boot");
}

TEST(Hub, TakesFiveViewsASecondAtMost) {
  Hub hub;
  FleetView view = test::made_view();
  offer_until_taken(hub, view);
  view.now_ns += 1;
  hub.offer(view);
  std::this_thread::sleep_for(milliseconds(50));
  EXPECT_EQ(hub.view()->now_ns, test::made_view().now_ns);
}

TEST(Hub, GivesAReaderFarBehindTheNewestView) {
  Hub hub;
  hub.join();
  FleetView view = test::made_view();
  offer_until_taken(hub, view);
  const Hub::Message first = hub.next(0, kPatience);
  for (std::size_t i = 0; i < Hub::kKept + 2; ++i) {
    view.now_ns += 1'000'000;
    ++view.frames;
    offer_until_taken(hub, view);
  }
  const Hub::Message late = hub.next(first.version, kPatience);
  ASSERT_TRUE(late.json);
  EXPECT_TRUE(late.whole);
  EXPECT_EQ(json::parse(*late.json)["frames"], view.frames);
  EXPECT_EQ(late.version, first.version + Hub::kKept + 2);
}

TEST(Hub, LetsAReaderCatchUpByChanges) {
  Hub hub;
  hub.join();
  FleetView view = test::made_view();
  offer_until_taken(hub, view);
  Hub::Message message = hub.next(0, kPatience);
  json seen = json::parse(*message.json);
  for (int i = 0; i < 3; ++i) {
    view.now_ns += 1'000'000;
    ++view.frames;
    offer_until_taken(hub, view);
  }
  for (int i = 0; i < 3; ++i) {
    message = hub.next(message.version, kPatience);
    ASSERT_TRUE(message.json);
    EXPECT_FALSE(message.whole);
    seen.merge_patch(json::parse(*message.json)["patch"]);
  }
  EXPECT_EQ(seen["frames"], view.frames);
}

TEST(EventStream, StartsWithAWholeView) {
  Hub hub;
  offer_until_taken(hub, test::made_view());
  EventStream stream(hub);
  EXPECT_EQ(stream.next(), "retry: 1000\n\n");
  const std::string whole = stream.next();
  EXPECT_TRUE(whole.starts_with("event: whole\ndata: {")) << whole;
  EXPECT_TRUE(whole.ends_with("}\n\n"));
}

TEST(EventStream, SaysThatItIsThereWhereNothingComes) {
  Hub hub;
  EventStream stream(hub);
  EXPECT_FALSE(stream.next().empty());
  EXPECT_EQ(stream.next(), ": still here\n\n");
}

TEST(EventStream, EndsWhenTheHubIsClosed) {
  Hub hub;
  EventStream stream(hub);
  EXPECT_FALSE(stream.next().empty());
  hub.close();
  EXPECT_TRUE(stream.next().empty());
}

}  // namespace
}  // namespace host_sim::monitor
