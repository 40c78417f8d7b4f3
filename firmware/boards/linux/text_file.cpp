#include "firmware/boards/linux/text_file.hpp"

#include <fmt/format.h>

#include "host_sim/io/byte_source.hpp"
#include "host_sim/io/input_error.hpp"

namespace board {

std::string read_small_file(const std::filesystem::path& path, std::size_t most_bytes,
                            std::string_view accepted) {
  const auto source = host_sim::open_source(path, accepted);
  std::string text(most_bytes + 1, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const std::size_t count = source->read({text.data() + size, text.size() - size});
    if (count == 0) {
      text.resize(size);
      return text;
    }
    size += count;
  }
  throw host_sim::InputError(path.string(), 0, 0, fmt::format("larger than {} bytes", most_bytes),
                             accepted);
}

}  // namespace board
