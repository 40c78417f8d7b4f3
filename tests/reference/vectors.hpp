#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace host_sim::reference::testing {

/// The named file of the folder of published vectors, or nothing if it is not there.
inline std::optional<nlohmann::json> load_vectors(const std::string& file) {
  std::ifstream in(std::string(TENDONLIFE_VECTORS) + "/" + file);
  if (!in) {
    return std::nullopt;
  }
  return nlohmann::json::parse(in);
}

}  // namespace host_sim::reference::testing

#define TENDONLIFE_LOAD_VECTORS_OR_SKIP(name, file)                                      \
  const auto name = ::host_sim::reference::testing::load_vectors(file);                  \
  if (!name) {                                                                           \
    GTEST_SKIP() << "NOT CHECKED: there is no " << TENDONLIFE_VECTORS << "/" << (file)   \
                 << "; configure with -DTENDONLIFE_SHARED=<folder that holds vectors/>"; \
  }                                                                                      \
  static_assert(true)
