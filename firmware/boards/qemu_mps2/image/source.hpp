#pragma once

#include <concepts>
#include <cstddef>
#include <span>

namespace firmware::qemu_mps2 {

/// A file that is read from its begin to its end; read() gives fewer bytes than asked for only
/// there.
template <class T>
concept Source = requires(T& source, std::span<std::byte> out) {
  { source.read(out) } -> std::same_as<std::size_t>;
};

/// A file that is written; write() is true where all bytes were.
template <class T>
concept Sink = requires(T& sink, std::span<const std::byte> bytes) {
  { sink.write(bytes) } -> std::same_as<bool>;
};

}  // namespace firmware::qemu_mps2
