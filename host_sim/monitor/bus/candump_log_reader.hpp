#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "host_sim/io/candump.hpp"
#include "host_sim/monitor/bus/log_reader.hpp"

namespace host_sim::monitor {

/// A log of candump -L. Lines of all interfaces are taken.
class CandumpLogReader final : public LogReader {
 public:
  /// `-` is standard input. @throws InputError
  explicit CandumpLogReader(const std::filesystem::path& path)
      : name_(path.string()), reader_(path) {}
  CandumpLogReader(std::unique_ptr<ByteSource> source, std::string_view name)
      : name_(name), reader_(std::move(source), name) {}

  std::optional<SeenFrame> next() override;

 private:
  std::string name_;
  CandumpReader reader_;
};

}  // namespace host_sim::monitor
