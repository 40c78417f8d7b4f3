#include <string_view>

#include "firmware/protocol/generate/generate.hpp"
#include "firmware/protocol/uds/describe.hpp"

namespace protocol::generate {

std::string services() {
  std::string text;
  uds::describe([&text](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace protocol::generate
