#include "host_sim/campaign/is_there.hpp"

#include <system_error>

namespace host_sim {

bool is_there(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::symlink_status(file, error).type() !=
         std::filesystem::file_type::not_found;
}

}  // namespace host_sim
