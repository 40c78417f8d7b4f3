#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "host_sim/monitor/record/recorder.hpp"
#include "host_sim/monitor/watch/observer.hpp"

namespace host_sim::monitor {

/// Records what is seen.
class RecordObserver final : public Observer {
 public:
  /// @throws OutputError
  RecordObserver(const std::filesystem::path& folder, const Rotation& rotation,
                 std::string interface)
      : recorder_(folder, rotation, std::move(interface)) {}

  void see(const SeenFrame& seen) override { recorder_.see(seen); }
  [[nodiscard]] std::string trouble() const override { return recorder_.trouble(); }
  [[nodiscard]] const std::string& repaired() const { return recorder_.repaired(); }
  /// All that was seen can be read in the folder, or trouble() says why not.
  void flush() { recorder_.flush(); }
  /// All that was seen is on the disk, or trouble() says why not.
  void finish() override { recorder_.sync(); }

 private:
  Recorder recorder_;
};

}  // namespace host_sim::monitor
