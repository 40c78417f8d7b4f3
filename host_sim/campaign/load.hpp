#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "hal/files/text.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/csv_table.hpp"

namespace host_sim {

/// The places of the numbers in load_keys().
enum LoadKeyId : unsigned {
  kBendAngleKey,
  kOutputMeanKey,
  kOutputAmplitudeKey,
  kInputMeanKey,
  kInputAmplitudeKey,
  kEffectiveTensionKey,  ///< in campaign.toml alone
  kLoadKeyCount,
};

/// The numbers in the first places of load_keys() that a CSV file may give.
inline constexpr std::size_t kLoadColumnCount = kEffectiveTensionKey;

/// The numbers that may give a load.
std::span<const hal::files::NumberKey, kLoadKeyCount> load_keys();

/// What gives a load in a CSV file, in words; and in a use of campaign.toml.
std::string_view load_keys_prose();
std::string_view load_keys_prose_of_use();

enum class LoadKind {
  none,
  output_tension,  ///< with the bend angle
  input_tension,
  effective_tension,
};

/// A load as it stands in a file.
struct GivenLoad {
  struct Number {
    bool given = false;
    double value = 0;
    FilePosition place;  ///< also of a cell that is empty
  };
  std::array<Number, kLoadKeyCount> numbers{};
  std::string_view accepted = load_keys_prose();  ///< what errors say is accepted

  /// What kind of load the numbers give.
  /// @throws InputError where they give half a kind, or more than one
  [[nodiscard]] LoadKind kind() const;

  /// The same for its errors alone.
  void check() const;

  /// The numbers of one kind alone.
  [[nodiscard]] GivenLoad only(LoadKind kind) const;

  [[nodiscard]] double value(LoadKeyId id) const { return numbers[id].value; }

  /// Where the first of the numbers that are given stands.
  /// @pre kind() is not none
  [[nodiscard]] const FilePosition& place() const;
};

/// Makes loads of what files give, with the nominal model of a campaign.
class LoadModel {
 public:
  /// `model` is the place of [model] in campaign.toml, for errors where it lacks a table. The
  /// nominal model must outlive this.
  LoadModel(const NominalModel& nominal, FilePosition model);

  /// Input tension from output tension by the capstan equation (14), (12) and (13), effective
  /// tension by Gerber's equation (11). An effective tension that is given stands for an input
  /// tension of this amplitude around zero.
  /// @pre given.kind() is not none
  /// @throws InputError where the model lacks what is needed, where the input tension reaches the
  /// ultimate tension, and where the effective tension is below kLeastTension_N
  Campaign::Load load(const GivenLoad& given) const;

  static constexpr double kLeastTension_N = 1e-3;

 private:
  double ultimate_tension_N(const GivenLoad& given) const;
  void input_from_output(const GivenLoad& given, Campaign::Load& load) const;
  [[noreturn]] void fail_missing(const GivenLoad& given, std::string_view table,
                                 std::string_view key) const;

  const NominalModel* nominal_;
  FilePosition model_;
};

}  // namespace host_sim
