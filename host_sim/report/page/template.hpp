#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <string_view>

namespace host_sim {

/// The texts that go into the `{{name}}` slots of a template; they are inserted as they are.
using Slots = std::map<std::string_view, std::string, std::less<>>;

/// Writes the template with its slots filled, in one pass: braces inside inserted text stay.
/// Throws std::logic_error for a slot without text and for one that is not closed.
void fill_template(std::ostream& out, std::string_view page, const Slots& slots);

}  // namespace host_sim
