#pragma once

#include <string_view>

namespace protocol::generate::assets {

/// decoder.mjs: what follows the plan in the JavaScript decoder.
extern const std::string_view decoder_mjs;

}  // namespace protocol::generate::assets
