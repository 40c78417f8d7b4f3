#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "host_sim/model/model.hpp"
#include "host_sim/report/compare/comparison.hpp"

namespace host_sim::compare {

/// A profile and the model that it is replayed with, by their files.
struct Replayed {
  std::string profile;
  std::string model_file;
  Model model;
};

/// Both replayed, and what differs. @param of_models two models with one profile, else two profiles
/// with one model
/// @param look is called now and then, and may throw
/// @throws InputError as replay()
Comparison compare(const Replayed& a, const Replayed& b, bool of_models,
                   const std::function<void()>& look);

/// One object with the fields of the file format; what is infinite is null.
std::string compare_json(const Comparison& comparison);

/// A few lines for people.
void write_compare(std::ostream& out, const Comparison& comparison);

}  // namespace host_sim::compare
