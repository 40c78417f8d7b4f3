#include "host_sim/compare/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "hal/files/input_error.hpp"
#include "host_sim/model/model_tables.hpp"
#include "host_sim/replay/replay.hpp"
#include "host_sim/replay/results.hpp"

namespace host_sim::compare {

using hal::files::InputError;
using hal::files::ProfileReader;
using hal::files::ProfileRow;

namespace {

constexpr double kClassesInUltimate = 1024;

ReplayResult replayed(const Replayed& of, const ReplayOptions& options) {
  ProfileReader profile(of.profile);
  return replay(profile, of.model, of.model_file, options);
}

Side side_of(const Replayed& of, double class_N, const std::function<void()>& look) {
  Side side{of.profile, of.model_file, {}, {}};
  ReplayOptions options;
  options.report = &side.report;
  options.class_N = class_N;
  options.progress = [&look](std::uint64_t) { look(); };
  const ReplayResult result = replayed(of, options);
  fill_report(side.report, result, of.model);
  side.unit = result.input == hal::files::InputKind::kMotorCurrent ? "A" : "N";
  return side;
}

using Numbers = std::map<std::string, double>;

bool has_table(const Model& model, std::string_view table) {
  return table != "drive" || model.drive.has_value();
}

Numbers numbers_of(const Extension* extension) {
  Numbers numbers;
  for (const Extension::Value& value :
       extension == nullptr ? std::vector<Extension::Value>() : extension->values) {
    for (std::size_t i = 0; i < value.values.size(); ++i) {
      numbers[value.values.size() == 1 ? value.name : fmt::format("{}[{}]", value.name, i)] =
          value.values[i];
    }
  }
  return numbers;
}

/// How much it changes the life; what cannot be said stands last.
double weight(const Difference& difference) {
  const double change = difference.life_ratio ? std::abs(std::log(*difference.life_ratio)) : -1;
  return std::isnan(change) ? -1 : change;
}

/// Exchanges what differs between two models, one thing after the other.
class Exchange {
 public:
  /// @param a_B10 life of A
  Exchange(const Replayed& a, const Replayed& b, double a_B10) : a_(a), b_(b), a_B10_(a_B10) {}

  std::vector<Difference> differences() {
    add_keys();
    std::set<std::string> ids;
    for (const Replayed* const one : {&a_, &b_}) {
      for (const Extension& extension : one->model.extensions) {
        ids.insert(extension.id);
      }
    }
    for (const std::string& id : ids) {
      add_extension(id);
    }
    std::ranges::stable_sort(differences_, std::greater<>(), weight);
    return differences_;
  }

 private:
  /// The B10 life of A with one thing changed, over that of A.
  [[nodiscard]] std::optional<double> life_ratio_with(
      const std::function<void(Model&)>& change) const {
    Replayed changed = a_;
    change(changed.model);
    if (!(changed.model.counting.hysteresis_N < changed.model.cable.ultimate_tension_N)) {
      return std::nullopt;
    }
    try {
      return ratio(replayed(changed, {}).repeats_to.b10, a_B10_);
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

  void add_keys() {
    Model of_a = a_.model, of_b = b_.model;
    for (const ModelKey& key : model_keys()) {
      const auto value = [&key](Model& model) {
        return has_table(model, key.table) ? std::optional(key.value(model)) : std::nullopt;
      };
      Difference found{fmt::format("{}.{}", key.table, key.key), value(of_a), value(of_b), {}};
      if (found.a == found.b) {
        continue;
      }
      if (found.a && found.b) {
        found.life_ratio = life_ratio_with([&](Model& model) { key.value(model) = *found.b; });
      }
      differences_.push_back(std::move(found));
    }
  }

  /// Extensions are changed as a whole: their numbers are fitted together.
  void add_extension(const std::string& id) {
    const Extension* const other = extension_of(b_.model.extensions, id);
    const Numbers of_a = numbers_of(extension_of(a_.model.extensions, id));
    const Numbers of_b = numbers_of(other);
    if (of_a == of_b) {
      return;
    }
    const std::optional<double> life_ratio = life_ratio_with([&](Model& model) {
      std::erase_if(model.extensions, [&id](const Extension& one) { return one.id == id; });
      if (other != nullptr) {
        model.extensions.push_back(*other);
        std::ranges::sort(model.extensions, {}, &Extension::id);
      }
    });
    Numbers all = of_a;
    all.insert(of_b.begin(), of_b.end());
    for (const auto& [name, ignored] : all) {
      const auto value = [&name = name](const Numbers& numbers) {
        const auto found = numbers.find(name);
        return found == numbers.end() ? std::nullopt : std::optional(found->second);
      };
      if (value(of_a) != value(of_b)) {
        differences_.push_back(
            {fmt::format("extension.{}.{}", id, name), value(of_a), value(of_b), life_ratio});
      }
    }
  }

  const Replayed& a_;
  const Replayed& b_;
  double a_B10_;
  std::vector<Difference> differences_;
};

/// The rows of a profile one by one.
class Rows {
 public:
  explicit Rows(const std::string& path) : reader_(path) {}

  /// Null at the end.
  const ProfileRow* next() {
    if (at_ == block_.size()) {
      block_ = reader_.read_block();
      at_ = 0;
    }
    return block_.empty() ? nullptr : &block_[at_++];
  }
  [[nodiscard]] hal::files::InputKind kind() const { return reader_.kind(); }

 private:
  ProfileReader reader_;
  std::span<const ProfileRow> block_;
  std::size_t at_ = 0;
};

/// What the replay reads of a row, but for its line.
bool same_sample(const ProfileRow& a, const ProfileRow& b) {
  return a.time_s == b.time_s && a.value == b.value &&
         a.tendon_velocity_m_s == b.tendon_velocity_m_s && a.bend_angle_deg == b.bend_angle_deg &&
         a.motor_angle_rad == b.motor_angle_rad &&
         a.sheath_temperature_C == b.sheath_temperature_C &&
         a.winding_temperature_C == b.winding_temperature_C;
}

std::optional<FirstDifference> first_difference(const std::string& path_a,
                                                const std::string& path_b) {
  Rows rows_a(path_a), rows_b(path_b);
  for (;;) {
    const ProfileRow* const a = rows_a.next();
    const ProfileRow* const b = rows_b.next();
    if (a == nullptr && b == nullptr) {
      return std::nullopt;
    }
    if (a != nullptr && b != nullptr && rows_a.kind() == rows_b.kind() && same_sample(*a, *b)) {
      continue;
    }
    FirstDifference first;
    first.time_s = a != nullptr ? a->time_s : b->time_s;
    if (a != nullptr) {
      first.line_a = a->line;
      first.a = a->value;
    }
    if (b != nullptr) {
      first.line_b = b->line;
      first.b = b->value;
    }
    return first;
  }
}

/// Numbers of classes of range and mean in the widths of both sides, which divide each other.
std::vector<CycleClass> classes_of(const std::array<Side, 2>& sides) {
  const auto width = [&sides](double RangeMeanMatrix::*step) {
    return std::max(sides[0].report.range_mean.*step, sides[1].report.range_mean.*step);
  };
  const double range_step_N = width(&RangeMeanMatrix::range_step_N);
  const double mean_step_N = width(&RangeMeanMatrix::mean_step_N);
  std::map<std::array<double, 2>, CycleClass> classes;
  for (std::size_t side = 0; side < 2; ++side) {
    const RangeMeanMatrix& matrix = sides[side].report.range_mean;
    for (std::size_t i = 0; i < matrix.count.size(); ++i) {
      if (!(matrix.count[i] > 0)) {
        continue;
      }
      const double middle = 0.5;  // of a class: never on the edge of a wider one
      const std::size_t range_class = i / matrix.means;
      const std::size_t mean_class = i % matrix.means;
      const double range = static_cast<double>(range_class) + middle;
      const double mean = static_cast<double>(mean_class) + middle;
      const std::array<double, 2> place{
          std::floor(range * matrix.range_step_N / range_step_N),
          std::floor((matrix.mean_min_N + mean * matrix.mean_step_N) / mean_step_N)};
      CycleClass& one = classes[place];
      one.range_N = {place[0] * range_step_N, (place[0] + 1) * range_step_N};
      one.mean_N = {place[1] * mean_step_N, (place[1] + 1) * mean_step_N};
      one.cycles[side] += matrix.count[i];
      one.damage[side] += matrix.damage[i];
    }
  }
  std::vector<CycleClass> all;
  all.reserve(classes.size());
  for (const auto& [place, one] : classes) {
    all.push_back(one);
  }
  std::ranges::stable_sort(all, std::greater<>(),
                           [](const CycleClass& one) { return std::abs(one.more_damage()); });
  return all;
}

/// Of a reading of damage at a time since the first one; nothing beyond the last.
std::optional<double> damage_at(const Trajectory& trajectory, double since_s) {
  const double time_s = trajectory.time_s.front() + since_s;
  const auto after = std::ranges::lower_bound(trajectory.time_s, time_s);
  if (after == trajectory.time_s.end()) {
    return std::nullopt;
  }
  const auto i = static_cast<std::size_t>(after - trajectory.time_s.begin());
  if (i == 0) {
    return trajectory.damage.front();
  }
  const double share =
      (time_s - trajectory.time_s[i - 1]) / (trajectory.time_s[i] - trajectory.time_s[i - 1]);
  return trajectory.damage[i - 1] + share * (trajectory.damage[i] - trajectory.damage[i - 1]);
}

std::optional<double> apart_after(const Side& a, const Side& b) {
  const Trajectory& of_a = a.report.trajectory;
  const Trajectory& of_b = b.report.trajectory;
  const double least = kApart * std::max(a.report.damage.total, b.report.damage.total);
  for (std::size_t i = 0; i < of_a.time_s.size(); ++i) {
    const double since_s = of_a.time_s[i] - of_a.time_s.front();
    const auto other = damage_at(of_b, since_s);
    if (!other) {
      return std::nullopt;
    }
    if (std::abs(of_a.damage[i] - *other) > least) {
      return since_s;
    }
  }
  return std::nullopt;
}

}  // namespace

Comparison compare(const Replayed& a, const Replayed& b, bool of_models,
                   const std::function<void()>& look) {
  Comparison comparison;
  comparison.of_models = of_models;
  const double class_N =
      std::max(a.model.cable.ultimate_tension_N, b.model.cable.ultimate_tension_N) /
      kClassesInUltimate;
  comparison.sides = {side_of(a, class_N, look), side_of(b, class_N, look)};
  if (of_models) {
    comparison.differences = Exchange(a, b, comparison.a().report.repeats_to.B10).differences();
  } else {
    comparison.first = first_difference(a.profile, b.profile);
  }
  comparison.classes = classes_of(comparison.sides);
  comparison.apart_s = apart_after(comparison.a(), comparison.b());
  return comparison;
}

}  // namespace host_sim::compare
