#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "firmware/protocol/messages.hpp"

/// Lines of `candump -L` for export.
namespace host_sim::monitor {

/// The node that a line is of: sender, or whom it is meant for. None for frames that are not of the
/// plan.
[[nodiscard]] std::optional<protocol::Node> node_of_line(std::string_view line);

/// Hands `lines`, whole ones, to `take`: all, or those of `node` alone. Whether it wants more.
bool take_lines(std::string_view lines, std::optional<protocol::Node> node,
                const std::function<bool(std::string_view)>& take);

}  // namespace host_sim::monitor
