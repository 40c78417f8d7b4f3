#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "host_sim/model/model.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"
#include "host_sim/monitor/fleet/watch.hpp"

namespace host_sim::monitor {

/// Writes each tendon that broke on the bus, or was replaced whole, as a row of a specimens.csv
/// that `calibrate` reads, as soon as its cycles are known. The constant effective tension that
/// does the same damage in as many cycles is (A D / n)^(1 / gamma), by the life that the nodes
/// count with: of one that counts with other parameters there is no row.
class SpecimenFile final : public Observer {
 public:
  /// What is there is continued; a life that is in it is not written twice. The file is whole at
  /// any moment, and there from the first update on.
  /// @param configuration CRC-32 of the parameter block that each tendon of the nodes counts with
  /// @throws InputError where a file is there that has other columns or ends within a line
  /// @throws OutputError
  SpecimenFile(const std::filesystem::path& path, const Model::Life& life,
               std::uint32_t configuration);

  void update(const FleetView& view) override;
  /// That a row could not be written, the nodes that count with other parameters, or the lives
  /// whose cycles are not known.
  [[nodiscard]] std::string trouble() const override;

 private:
  /// Whether a node counts with the parameters of the model; none while it has not said so.
  [[nodiscard]] std::optional<bool> counts_with_model(const NodeView& node) const;
  void write(const std::string& name, const WireLife& life);
  bool save(const std::string& what, const std::string& text);

  std::filesystem::path path_;
  Model::Life life_;
  std::string text_;  ///< of the whole file
  bool begun_ = false;
  std::set<std::string, std::less<>> written_;
  std::set<std::uint32_t> configurations_;          ///< that nodes report which count so
  std::map<std::string, std::string> not_written_;  ///< by name of the specimen or node: why
};

}  // namespace host_sim::monitor
