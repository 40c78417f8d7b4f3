#include <algorithm>
#include <array>

#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/plan/plan.hpp"

namespace host_sim::synth {
namespace {

constexpr std::size_t kLists = 8;
using Lists = std::array<const std::vector<double>*, kLists>;
using Places = std::array<std::size_t, kLists>;  // of one value in each list

Lists lists_of(const RecordingPlan& plan) {
  return {&plan.bend_angles_deg,  &plan.output_means_N, &plan.output_amplitudes_N,
          &plan.frequencies_Hz,   &plan.travels_mm,     &plan.sheath_ambients_C,
          &plan.winding_starts_C, &plan.start_cycles};
}

Setting setting_at(const Lists& lists, const Places& places) {
  const auto value = [&](std::size_t list) { return (*lists[list])[places[list]]; };
  Setting setting;
  setting.pose = places[0];
  setting.bend_angle_deg = value(0);
  setting.output_mean_N = value(1);
  setting.output_amplitude_N = value(2);
  setting.frequency_Hz = value(3);
  setting.travel_mm = value(4);
  setting.sheath_ambient_C = value(5);
  setting.winding_start_C = value(6);
  setting.start_cycle = value(7);
  return setting;
}

std::size_t longest(const Lists& lists) {
  std::size_t most = 0;
  for (const auto* list : lists) {
    most = std::max(most, list->size());
  }
  return most;
}

std::size_t product(const Lists& lists) {
  std::size_t count = 1;
  for (const auto* list : lists) {
    count = std::min(count * list->size(), kMostSessions + 1);
  }
  return count;
}

Places crossed(const Lists& lists, std::size_t number) {
  Places places{};
  for (std::size_t list = kLists; list-- > 0;) {
    places[list] = number % lists[list]->size();
    number /= lists[list]->size();
  }
  return places;
}

Places listed(const Lists& lists, std::size_t number) {
  Places places{};
  for (std::size_t list = 0; list < kLists; ++list) {
    places[list] = lists[list]->size() == 1 ? 0 : number;
  }
  return places;
}

/// Each place as often as the others, but for one, in random order (Fisher and Yates).
std::vector<std::size_t> shuffled(std::size_t count, std::size_t places, std::uint64_t seed,
                                  std::size_t list) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    order[i] = i % places;
  }
  Random random(seed, kDesignStream, list);
  for (std::size_t i = count; i > 1; --i) {
    const auto other = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
    std::swap(order[i - 1], order[other]);
  }
  return order;
}

std::vector<Places> balanced(const Lists& lists, std::size_t count, std::uint64_t seed) {
  std::vector<Places> all(count);
  for (std::size_t list = 0; list < kLists; ++list) {
    const auto order = shuffled(count, lists[list]->size(), seed, list);
    for (std::size_t i = 0; i < count; ++i) {
      all[i][list] = order[i];
    }
  }
  return all;
}

std::size_t count_without_repeats(const RecordingPlan& plan, const Lists& lists) {
  switch (plan.design) {
    case RecordingPlan::Design::crossed:
      return product(lists);
    case RecordingPlan::Design::listed:
      return longest(lists);
    case RecordingPlan::Design::balanced:
      break;
  }
  return plan.sessions;
}

}  // namespace

std::size_t session_count(const RecordingPlan& plan) {
  return plan.repeats * count_without_repeats(plan, lists_of(plan));
}

std::vector<Setting> settings_of(const RecordingPlan& plan, std::uint64_t seed) {
  const Lists lists = lists_of(plan);
  const std::size_t count = count_without_repeats(plan, lists);
  std::vector<Places> places;
  if (plan.design == RecordingPlan::Design::balanced) {
    places = balanced(lists, count, seed);
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      places.push_back(plan.design == RecordingPlan::Design::crossed ? crossed(lists, i)
                                                                     : listed(lists, i));
    }
  }
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < count * plan.repeats; ++i) {
    settings.push_back(setting_at(lists, places[i % count]));
    settings.back().number = i;
  }
  return settings;
}

}  // namespace host_sim::synth
