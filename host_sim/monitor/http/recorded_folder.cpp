#include "host_sim/monitor/http/recorded_folder.hpp"

#include <fstream>
#include <string>

#include "host_sim/monitor/http/frame_lines.hpp"
#include "host_sim/monitor/record/log_folder.hpp"

namespace host_sim::monitor {
namespace {

bool read_log(const std::filesystem::path& path, std::optional<protocol::Node> node,
              const std::function<bool(std::string_view)>& take) {
  constexpr std::size_t kPiece = std::size_t{256} << 10;
  std::ifstream log(path, std::ios::binary);
  std::string text;
  while (log) {
    const std::size_t rest = text.size();
    text.resize(rest + kPiece);
    log.read(text.data() + rest, static_cast<std::streamsize>(kPiece));
    text.resize(rest + static_cast<std::size_t>(log.gcount()));
    const std::size_t whole = text.rfind('\n') + 1;
    if (whole > 0 && !take_lines(std::string_view(text).substr(0, whole), node, take)) {
      return false;
    }
    text.erase(0, whole);
  }
  return true;
}

}  // namespace

void RecordedFolder::read(std::optional<protocol::Node> node,
                          const std::function<bool(std::string_view)>& take) const {
  flush_();
  for (const std::filesystem::path& log : logs_in(folder_)) {
    if (!read_log(log, node, take)) {
      return;
    }
  }
}

}  // namespace host_sim::monitor
