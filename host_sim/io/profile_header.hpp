#pragma once

#include <string_view>
#include <vector>

#include "host_sim/io/profile.hpp"
#include "host_sim/io/profile_columns.hpp"
#include "host_sim/io/text_place.hpp"

namespace host_sim {

/// What the header of a profile says.
struct ProfileHeader {
  InputKind kind;
  bool has_bend_angle;  ///< in the file and needed by `kind`
  std::vector<ProfileColumnId> columns;
};

/// The columns of a header line, `time_s` among them. Throws InputError for columns that are
/// unknown, of another unit or there twice; `needed` says there which columns a file must have.
std::vector<ProfileColumnId> parse_profile_columns(const TextPlace& line, std::string_view needed);

/// Reads a header line and chooses the kind of input. Throws InputError for columns that are
/// unknown, of another unit, missing or there twice.
ProfileHeader parse_profile_header(const TextPlace& line, const ProfileOptions& options);

}  // namespace host_sim
