#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"

namespace host_sim::diagnose {

/// One part of a diagnosis.
struct Part {
  std::string_view name;  ///< "recordings" or "lives"
  const Findings* findings = nullptr;
};

/// The parts that there are, recordings first. They point into `diagnosis`.
std::vector<Part> parts_of(const Diagnosis& diagnosis);

/// The findings of both parts in one: lists one after the other, sentences joined. The gain is that
/// of the parts that were extended; a metric that both have stands for the recordings, that of the
/// lives gets the name "lives_...".
Findings merged(const Diagnosis& diagnosis);

}  // namespace host_sim::diagnose
