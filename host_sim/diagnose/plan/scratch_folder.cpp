#include "host_sim/diagnose/plan/scratch_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "host_sim/io/output_file.hpp"

namespace host_sim::diagnose {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "host_sim-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw OutputError(name, std::strerror(errno));
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace host_sim::diagnose
