#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/toml_table.hpp"
#include "host_sim/synth/plan/plan.hpp"

namespace host_sim::synth {

/// The number of a key, or `standard` where the table leaves it out. @throws InputError
double number_or(const hal::files::TomlTable& table, const hal::files::NumberKey& key,
                 double standard);

/// A whole number. The same.
std::size_t whole_or(const hal::files::TomlTable& table, const hal::files::NumberKey& key,
                     std::size_t standard);

/// One number, or a list of at least one. @throws InputError, also where the key is not there
std::vector<double> numbers(const hal::files::TomlTable& table, const hal::files::NumberKey& key);

/// The same, or `standard` where the table leaves it out.
std::vector<double> numbers_or(const hal::files::TomlTable& table, const hal::files::NumberKey& key,
                               double standard);

/// The place in `names` of the name at a key, 0 where the table leaves it out. @throws InputError
std::size_t choice_of(const hal::files::TomlTable& table, std::string_view key,
                      std::span<const std::string_view> names);

/// The tables of an array of tables, none where the table leaves it out. @throws InputError
std::vector<hal::files::TomlTable> tables(const hal::files::TomlTable& above, std::string_view key);

/// [recordings] and [lives]. Throw InputError.
RecordingPlan recordings_in(const hal::files::TomlTable& table, bool two_sided);
LifePlan lives_in(const hal::files::TomlTable& table);

/// Throw InputError where [recordings], or [lives], do not agree with themselves or the model;
/// `top` is the whole file.
void check_recordings(const hal::files::TomlTable& top, const SynthPlan& plan);
void check_lives(const hal::files::TomlTable& top, const SynthPlan& plan);

/// @throws InputError that says which table of the model is missing, and what needs it
[[noreturn]] void fail_for_model(const hal::files::TomlTable& top, std::string_view table,
                                 std::string_view why);

}  // namespace host_sim::synth
