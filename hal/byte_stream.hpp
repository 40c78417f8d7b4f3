#pragma once

#include <concepts>
#include <cstddef>
#include <span>

namespace hal {

/// A serial line or what looks like one. Nothing waits.
///
/// try_read(): the oldest bytes that have arrived, as many as there are and fit; how many.
/// try_write(): takes bytes from the front, as many as there is room for; how many. They leave in
/// that order.
template <class T>
concept ByteStream = requires(T& stream, std::span<std::byte> out, std::span<const std::byte> in) {
  { stream.try_read(out) } -> std::same_as<std::size_t>;
  { stream.try_write(in) } -> std::same_as<std::size_t>;
};

}  // namespace hal
