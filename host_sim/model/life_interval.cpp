#include "host_sim/model/life_interval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "hal/files/text.hpp"
#include "host_sim/reference/equations.hpp"

namespace host_sim {

using hal::files::describe;
using hal::files::NumberKey;
using hal::files::NumberRange;
using hal::files::range_text;
using hal::files::toml_float;
using hal::files::TomlTable;

namespace {

using Interval = Model::Life::Interval;

constexpr NumberKey kLevel{"level", "", {0.0, 1.0, true}};
constexpr NumberKey kPivot{"pivot_tension_N", "N", {0.0, 1e6, true}};
constexpr NumberRange kEnd{0.0, 1e300, true};

/// An interval of one number of the life law.
struct EndsKey {
  std::string_view key;
  Interval::Ends Interval::*ends;
  double (*inside)(const Model::Life&, double pivot_tension_N);  ///< what it is the interval of
};

constexpr std::array<EndsKey, 4> kEnds{{
    {"ipl_scale", &Interval::ipl_scale,
     [](const Model::Life& life, double) { return life.ipl_scale; }},
    {"ipl_exponent", &Interval::ipl_exponent,
     [](const Model::Life& life, double) { return life.ipl_exponent; }},
    {"weibull_shape", &Interval::weibull_shape,
     [](const Model::Life& life, double) { return life.weibull_shape; }},
    {"life_at_pivot", &Interval::life_at_pivot,
     [](const Model::Life& life, double tension_N) {
       return reference::ipl_life_cycles(tension_N, life.ipl_scale, life.ipl_exponent);
     }},
}};

bool holds(const Interval::Ends& ends, double value) {
  return ends.low <= value && value <= ends.high;
}

Interval::Ends read_ends(const TomlTable& table, std::string_view key, double inside) {
  const std::string accepted =
      fmt::format("{} = [low, high], each {}, with {:.6g} between", key, range_text(kEnd), inside);
  const toml::node& node = table.node(key, accepted);
  const toml::array* const array = node.as_array();
  constexpr std::size_t kTwo = 2;
  if (array == nullptr || array->size() != kTwo) {
    table.fail(table.place_of(key),
               array == nullptr ? fmt::format("{} is {}", key, describe(node))
                                : fmt::format("{} has {} numbers", key, array->size()),
               accepted);
  }
  std::array<double, kTwo> ends{};
  for (std::size_t i = 0; i < kTwo; ++i) {
    const toml::node& element = (*array)[i];
    const auto value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value || !kEnd.contains(*value)) {
      table.fail(element.source().begin, fmt::format("{} holds {}", key, describe(element)),
                 accepted);
    }
    ends[i] = *value;
  }
  const Interval::Ends found{ends[0], ends[1]};
  if (!holds(found, inside)) {
    table.fail(table.place_of(key), fmt::format("{} is [{}, {}]", key, found.low, found.high),
               accepted);
  }
  return found;
}

double read_level(const TomlTable& table) {
  const double level = table.number(kLevel);
  if (level >= kLevel.range.maximum) {
    table.fail(table.place_of(kLevel.name), fmt::format("level is {}", level),
               "level above 0 and below 1");
  }
  return level;
}

}  // namespace

Interval read_life_interval(const TomlTable& table, const Model::Life& life) {
  constexpr std::array kNumbers{kLevel, kPivot};
  std::array<std::string_view, kEnds.size()> others;
  std::ranges::transform(kEnds, others.begin(), &EndsKey::key);
  table.refuse_unknown_keys(kNumbers, others);
  Interval interval{};
  interval.level = read_level(table);
  interval.pivot_tension_N = table.number(kPivot);
  for (const EndsKey& one : kEnds) {
    interval.*one.ends = read_ends(table, one.key, one.inside(life, interval.pivot_tension_N));
  }
  return interval;
}

bool can_be_written(const Interval& interval, const Model::Life& life) {
  return kPivot.range.contains(interval.pivot_tension_N) &&
         std::ranges::all_of(kEnds, [&](const EndsKey& one) {
           const Interval::Ends& ends = interval.*one.ends;
           return kEnd.contains(ends.low) && kEnd.contains(ends.high) &&
                  holds(ends, one.inside(life, interval.pivot_tension_N));
         });
}

std::string life_interval_text(const Interval& interval, std::string_view prefix) {
  std::string text =
      fmt::format("{0}{1} = {2}\n{0}{3} = {4}\n", prefix, kLevel.name, toml_float(interval.level),
                  kPivot.name, toml_float(interval.pivot_tension_N));
  for (const EndsKey& one : kEnds) {
    const Interval::Ends& ends = interval.*one.ends;
    text += fmt::format("{}{} = [{}, {}]\n", prefix, one.key, toml_float(ends.low),
                        toml_float(ends.high));
  }
  return text;
}

}  // namespace host_sim
