#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/text.hpp"

namespace host_sim::synth {

/// A number that the table of an effect may give.
struct Parameter {
  hal::files::NumberKey key;
  std::optional<double> standard = {};  ///< where the table leaves it out; without it, required
  bool list = false;                    ///< one number, or a list of them
};

/// A name that the table of an effect may give.
struct Choice {
  std::string_view name;
  std::vector<std::string_view> names;  ///< the first where the table leaves it out
};

/// What the table of an effect says, complete and checked.
class Values {
 public:
  void set(std::string_view name, std::vector<double> numbers) {
    numbers_[std::string(name)] = std::move(numbers);
  }
  void choose(std::string_view name, std::string_view chosen) {
    choices_[std::string(name)] = std::string(chosen);
  }

  /// @pre a parameter of the effect
  [[nodiscard]] double operator[](std::string_view name) const {
    return numbers_.at(std::string(name)).front();
  }
  [[nodiscard]] const std::vector<double>& list(std::string_view name) const {
    return numbers_.at(std::string(name));
  }
  /// @pre a choice of the effect
  [[nodiscard]] const std::string& choice(std::string_view name) const {
    return choices_.at(std::string(name));
  }

  [[nodiscard]] const std::map<std::string, std::vector<double>>& numbers() const {
    return numbers_;
  }
  [[nodiscard]] const std::map<std::string, std::string>& choices() const { return choices_; }

 private:
  std::map<std::string, std::vector<double>> numbers_;
  std::map<std::string, std::string> choices_;
};

}  // namespace host_sim::synth
