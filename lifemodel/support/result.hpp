#pragma once

#include <optional>

namespace lifemodel {

/// A value, or the reason why there is none.
template <class T, class E>
class [[nodiscard]] Result {
 public:
  constexpr Result(const T& value) : value_(value) {}  // NOLINT(google-explicit-constructor)
  constexpr Result(E error) : error_(error) {}         // NOLINT(google-explicit-constructor)

  [[nodiscard]] constexpr explicit operator bool() const { return value_.has_value(); }
  /// @pre there is a value
  [[nodiscard]] constexpr const T& operator*() const { return *value_; }
  [[nodiscard]] constexpr const T* operator->() const { return &*value_; }
  /// @pre there is no value
  [[nodiscard]] constexpr E error() const { return error_; }

 private:
  std::optional<T> value_;
  E error_{};
};

}  // namespace lifemodel
