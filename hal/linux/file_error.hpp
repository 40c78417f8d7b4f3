#pragma once

#include <string>

namespace hal::linux_os {

/// What is wrong with a file: where, what, and what is accepted.
struct FileError {
  std::string path;
  std::string what;
};

/// One line.
inline std::string to_string(const FileError& error) {
  return error.path + ": " + error.what;
}

}  // namespace hal::linux_os
