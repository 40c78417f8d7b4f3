#include "host_sim/monitor/fleet/pages.hpp"

#include "firmware/protocol/codec.hpp"

namespace host_sim::monitor {
namespace {

namespace detail = protocol::detail;

class PageTaker {
 public:
  PageTaker(const hal::CanFrame& frame, std::int64_t time_ns) : frame_(frame), time_ns_(time_ns) {}

  template <class Page>
  bool take(std::optional<Timed<Page>>& place) const {
    const auto page = protocol::decode<Page>(frame_);
    if (!page) {
      return false;
    }
    place = {*page, time_ns_};
    return true;
  }

  template <class Key, class Page, class KeyOf>
  bool take(std::map<Key, Timed<Page>>& places, KeyOf key_of) const {
    const auto page = protocol::decode<Page>(frame_);
    if (!page) {
      return false;
    }
    places[key_of(*page)] = {*page, time_ns_};
    return true;
  }

 private:
  const hal::CanFrame& frame_;
  std::int64_t time_ns_;
};

std::uint16_t place_of(const detail::RainflowBin& bin) {
  return static_cast<std::uint16_t>(64 * bin.tendon + 8 * bin.range_class + bin.mean_class);
}

}  // namespace

bool take_page(const hal::CanFrame& frame, std::int64_t time_ns, NodeView& view) {
  const PageTaker taker(frame, time_ns);
  return taker.take(view.identity) || taker.take(view.cycles) || taker.take(view.rate) ||
         taker.take(view.tendons, [](const detail::TendonDamage& page) { return page.tendon; }) ||
         taker.take(view.bins, place_of) || taker.take(view.remaining) ||
         taker.take(view.storage) || taker.take(view.timing) || taker.take(view.bus);
}

}  // namespace host_sim::monitor
