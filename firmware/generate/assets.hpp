#pragma once

#include <string_view>

namespace protocol::generate::assets {

/// decoder.mjs: what follows the plan in the JavaScript decoder.
extern const std::string_view decoder_mjs;  // NOLINT(readability-identifier-naming)

}  // namespace protocol::generate::assets
