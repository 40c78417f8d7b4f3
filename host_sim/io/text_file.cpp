#include "host_sim/io/text_file.hpp"

#include <cstddef>

#include "host_sim/io/byte_source.hpp"
#include "host_sim/io/input_error.hpp"

namespace host_sim {
namespace {

constexpr std::size_t kSizeLimit = std::size_t{1} << 20;

}  // namespace

std::string read_text_file(const std::filesystem::path& path, std::string_view accepted) {
  const auto source = open_source(path, accepted);
  std::string text(kSizeLimit + 1, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const std::size_t count = source->read({text.data() + size, text.size() - size});
    if (count == 0) {
      text.resize(size);
      return text;
    }
    size += count;
  }
  throw InputError(path.string(), 0, 0, "larger than 1 MiB", accepted);
}

std::string file_name(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path.string();
}

}  // namespace host_sim
