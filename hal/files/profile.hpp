#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "hal/files/input_file.hpp"
#include "hal/files/profile_columns.hpp"

namespace hal::files {

/// What a profile says about the load of the tendon.
enum class InputKind {
  kInputTension,   ///< `input_tension_N`
  kMotorCurrent,   ///< `motor_current_A`
  kOutputTension,  ///< `output_tension_N` and `tendon_velocity_m_s`
};

/// `input_tension`, `motor_current` or `output_tension`.
std::string_view to_string(InputKind kind);

/// The kind of that name, none if there is no such kind.
std::optional<InputKind> input_kind_from(std::string_view name);

struct ProfileOptions {
  /// The kind to read; without it the first in the order of InputKind that the file holds.
  std::optional<InputKind> input;
  /// How many parse the rows of a file, the caller among them; the rows do not depend on it. What
  /// is no file is not read ahead, so the caller alone parses that.
  unsigned threads = 1;
  ColumnOptions columns{};
};

/// What a profile is, for errors of a file that is none.
inline constexpr std::string_view kAcceptedProfile =
    "a CSV file with time_s and one of input_tension_N, motor_current_A, output_tension_N with "
    "tendon_velocity_m_s, or - for standard input";

/// One row of a profile. What the file does not hold is 0.
struct ProfileRow {
  double time_s;
  double value;                ///< tension in N, or current in A
  double tendon_velocity_m_s;  ///< positive while pulling
  double bend_angle_deg;       ///< only if has_bend_angle()
  double motor_angle_rad = 0;
  double sheath_temperature_C = 0;
  double winding_temperature_C = 0;
  std::uint64_t line = 0;  ///< of the file, from 1
};

/// Reads a profile (RFC 4180 CSV, see profile_columns.hpp) of any length in constant memory.
///
/// Rows come out finite, within the ranges of profile_columns() and with strictly increasing time;
/// anything else throws InputError. The constructor reads up to the first row, so that a file that
/// is not a profile is refused before any work. Lines, comments too, are at most 1 MiB long.
class ProfileReader {
 public:
  /// `-` reads standard input.
  explicit ProfileReader(const std::filesystem::path& path, const ProfileOptions& options = {});

  /// Reads from `source`; `name` stands for the file in errors.
  ProfileReader(std::unique_ptr<ByteSource> source, std::string_view name,
                const ProfileOptions& options = {});

  ProfileReader(ProfileReader&&) noexcept;
  ProfileReader& operator=(ProfileReader&&) noexcept;
  ~ProfileReader();

  InputKind kind() const noexcept;

  /// Whether the file holds `bend_angle_deg` and its kind needs it (kOutputTension).
  bool has_bend_angle() const noexcept;

  /// The columns that the file holds, by ProfileColumnId.
  ProfileChannels channels() const noexcept;

  /// Fields passed over whose names are nearly those of columns that are not there.
  const std::vector<NearlyColumn>& nearly() const noexcept;

  /// Fills the front of `rows` and returns how many; fewer than asked for only at the end, then 0.
  /// After an error the reader is of no further use.
  std::size_t read(std::span<ProfileRow> rows);

  /// The next rows, as many as are parsed at once; none at the end. They stay until the next call.
  /// After an error the reader is of no further use.
  std::span<const ProfileRow> read_block();

  /// Bytes of the file whose rows have been parsed and are being read.
  std::uint64_t bytes_read() const noexcept;

  /// Size of the file in bytes, 0 if unknown (a pipe).
  std::uint64_t bytes_total() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hal::files
