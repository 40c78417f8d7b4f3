#pragma once

namespace firmware::qemu_mps2 {

/// What went wrong, and with what: an option, or null for the run itself. Nothing did where `what`
/// is null.
struct [[nodiscard]] Failure {
  const char* about = nullptr;
  const char* what = nullptr;

  explicit operator bool() const { return what != nullptr; }
};

}  // namespace firmware::qemu_mps2
