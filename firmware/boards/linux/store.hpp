#pragma once

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <utility>
#include <variant>

#include "hal/linux/file_store.hpp"

namespace board {

/// Opens the store of a configuration, and warns of files that were found damaged. Throws
/// std::runtime_error with one line: path, what is wrong, what is accepted.
template <std::size_t kTendons>
hal::linux_os::FileStore<kTendons> open_store(const std::filesystem::path& folder) {
  auto store = hal::linux_os::FileStore<kTendons>::open(folder.string());
  if (const auto* const error = std::get_if<hal::linux_os::FileError>(&store)) {
    throw std::runtime_error(to_string(*error));
  }
  auto& opened = std::get<hal::linux_os::FileStore<kTendons>>(store);
  for (const hal::linux_os::FileError& notice : opened.notices()) {
    std::cerr << "tendonlife_controller: WARNING: " << to_string(notice) << '\n';
  }
  return std::move(opened);
}

}  // namespace board
