#include "hal/files/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "hal/files/profile_blocks.hpp"
#include "hal/files/profile_columns.hpp"
#include "hal/files/profile_rows.hpp"

namespace hal::files {
namespace {

constexpr std::array<std::string_view, 3> kKindNames{"input_tension", "motor_current",
                                                     "output_tension"};

/// What the header of a profile says.
struct ProfileHeader {
  InputKind kind;
  bool has_bend_angle;  ///< in the file and needed by `kind`
  ProfileLayout layout;
};

constexpr std::array<InputKind, 3> kKinds{InputKind::kInputTension, InputKind::kMotorCurrent,
                                          InputKind::kOutputTension};
constexpr std::string_view kNeeded =
    "time_s and one of input_tension_N, motor_current_A, output_tension_N with "
    "tendon_velocity_m_s";

ProfileColumnId value_column(InputKind kind) {
  switch (kind) {
    case InputKind::kInputTension:
      return kInputTensionColumn;
    case InputKind::kMotorCurrent:
      return kMotorCurrentColumn;
    case InputKind::kOutputTension:
      return kOutputTensionColumn;
  }
  return kProfileColumnCount;
}

bool holds(const ProfileChannels& present, InputKind kind) {
  return present[value_column(kind)] &&
         (kind != InputKind::kOutputTension || present[kTendonVelocity]);
}

[[noreturn]] void fail_missing(const TextPlace& line, std::string_view column) {
  line.fail(line.text.size(), fmt::format("no column {}", column), kNeeded);
}

InputKind chosen_kind(const ProfileChannels& present, const TextPlace& line,
                      const ProfileOptions& options) {
  for (const InputKind kind : kKinds) {
    if (options.input.value_or(kind) == kind && holds(present, kind)) {
      return kind;
    }
  }
  if (options.input && !present[value_column(*options.input)]) {
    fail_missing(line, profile_columns()[value_column(*options.input)].name);
  }
  if (present[kOutputTensionColumn]) {
    fail_missing(line, profile_columns()[kTendonVelocity].name);
  }
  fail_missing(line, "of tension or current");
}

/// Reads a header line and chooses the kind of input. Throws InputError for columns that are
/// unknown, of another unit, missing or there twice.
ProfileHeader parse_profile_header(const TextPlace& line, const ProfileOptions& options) {
  ProfileHeader header{};
  header.layout = parse_profile_columns(line, kNeeded, options.columns);
  const ProfileChannels& present = header.layout.channels;
  header.kind = chosen_kind(present, line, options);
  header.has_bend_angle = header.kind == InputKind::kOutputTension && present[kBendAngle];
  return header;
}

}  // namespace

std::string_view to_string(InputKind kind) {
  return kKindNames.at(static_cast<std::size_t>(kind));
}

std::optional<InputKind> input_kind_from(std::string_view name) {
  const auto* const found = std::find(kKindNames.begin(), kKindNames.end(), name);
  if (found == kKindNames.end()) {
    return std::nullopt;
  }
  return static_cast<InputKind>(found - kKindNames.begin());
}

class ProfileReader::Impl {
 public:
  Impl(std::unique_ptr<ByteSource> source, std::string_view name, const ProfileOptions& options)
      : lines_(std::move(source), std::string(name), ProfileBlocks::kWindow),
        header_(read_header(name, options)),
        blocks_(lines_, name, header_.layout, columns_of(header_),
                lines_.bytes_total() == 0
                    ? 1
                    : std::clamp(options.threads, 1U, ProfileBlocks::kMostThreads)) {}

  std::size_t read(std::span<ProfileRow> rows) {
    std::size_t count = 0;
    while (count < rows.size()) {
      if (block_.empty() && read_block().empty()) {
        break;
      }
      const std::size_t here = std::min(block_.size(), rows.size() - count);
      std::copy_n(block_.begin(), here, rows.begin() + static_cast<std::ptrdiff_t>(count));
      block_ = block_.subspan(here);
      count += here;
    }
    return count;
  }

  std::span<const ProfileRow> take_block() {
    const auto rows = block_.empty() ? read_block() : block_;
    block_ = {};
    return rows;
  }

  const ProfileHeader& header() const noexcept { return header_; }
  std::uint64_t bytes_read() const noexcept { return blocks_.bytes_read(); }
  std::uint64_t bytes_total() const noexcept { return lines_.bytes_total(); }

 private:
  ProfileHeader read_header(std::string_view name, const ProfileOptions& options) {
    ProfileHeader header{};
    read_profile_header(lines_, name, kAcceptedProfile, [&](const TextPlace& line) {
      header = parse_profile_header(line, options);
      return header.layout;
    });
    return header;
  }

  static ProfileRowColumns columns_of(const ProfileHeader& header) {
    ProfileRowColumns columns;
    columns.value = value_column(header.kind);
    if (header.has_bend_angle) {
      columns.bend = kBendAngle;
    }
    return columns;
  }

  std::span<const ProfileRow> read_block() { return block_ = blocks_.next(); }

  LineBuffer lines_;
  ProfileHeader header_;
  ProfileBlocks blocks_;
  std::span<const ProfileRow> block_;  ///< of which no row has been read
};

ProfileReader::ProfileReader(const std::filesystem::path& path, const ProfileOptions& options)
    : ProfileReader(open_source(path, kAcceptedProfile),
                    path == "-" ? std::string("standard input") : path.string(), options) {}

ProfileReader::ProfileReader(std::unique_ptr<ByteSource> source, std::string_view name,
                             const ProfileOptions& options)
    : impl_(std::make_unique<Impl>(std::move(source), name, options)) {}

ProfileReader::ProfileReader(ProfileReader&&) noexcept = default;
ProfileReader& ProfileReader::operator=(ProfileReader&&) noexcept = default;
ProfileReader::~ProfileReader() = default;

InputKind ProfileReader::kind() const noexcept {
  return impl_->header().kind;
}

bool ProfileReader::has_bend_angle() const noexcept {
  return impl_->header().has_bend_angle;
}

ProfileChannels ProfileReader::channels() const noexcept {
  return impl_->header().layout.channels;
}

const std::vector<NearlyColumn>& ProfileReader::nearly() const noexcept {
  return impl_->header().layout.nearly;
}

std::size_t ProfileReader::read(std::span<ProfileRow> rows) {
  return impl_->read(rows);
}

std::span<const ProfileRow> ProfileReader::read_block() {
  return impl_->take_block();
}

std::uint64_t ProfileReader::bytes_read() const noexcept {
  return impl_->bytes_read();
}

std::uint64_t ProfileReader::bytes_total() const noexcept {
  return impl_->bytes_total();
}

}  // namespace hal::files
