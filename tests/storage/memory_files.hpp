#pragma once

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "firmware/storage/file_io.hpp"
#include "hal/fake/random.hpp"

namespace storage_test {

/// One folder of files of which only what was synced outlives a power cut; what was not may be
/// there, in part, or not at all. Changes of names reach the disk in their order. Calls are counted
/// from 0.
class MemoryFiles {
 public:
  struct Fault {
    std::uint64_t call;
    enum class FaultKind : std::uint8_t { error, short_write, cut_before, cut_after } kind;
    int error = EIO;
  };

  explicit MemoryFiles(std::string folder) : folder_(std::move(folder)) {}
  MemoryFiles(const MemoryFiles& other) { *this = other; }
  MemoryFiles& operator=(const MemoryFiles& other) {
    folder_ = other.folder_;
    names_ = other.names_;
    durable_names_ = other.durable_names_;
    pending_ = other.pending_;
    open_ = other.open_;
    calls_ = other.calls_;
    fault_ = other.fault_;
    powered_ = other.powered_;
    nodes_.clear();
    for (const auto& node : other.nodes_) {
      nodes_.push_back(std::make_unique<Node>(*node));
    }
    return *this;
  }

  void fault(Fault fault) { fault_ = fault; }
  [[nodiscard]] std::uint64_t calls() const { return calls_; }
  [[nodiscard]] bool powered() const { return powered_; }
  [[nodiscard]] bool exists(const std::string& name) const {
    return names_.contains(folder_ + "/" + name);
  }
  [[nodiscard]] std::vector<std::byte>& content(const std::string& name) {
    return nodes_[names_.at(folder_ + "/" + name)]->content;
  }
  void remove(const std::string& name) {
    names_.erase(folder_ + "/" + name);
    durable_names_ = names_;
  }

  /// Power is back. `seed` decides what became of that which was not synced.
  void restart(std::uint64_t seed) {
    hal::fake::Random random(seed);
    const std::size_t done = random.below(static_cast<std::uint32_t>(pending_.size() + 1));
    for (std::size_t i = 0; i < done; ++i) {
      durable_names_ = pending_[i];
    }
    pending_.clear();
    names_ = durable_names_;
    for (const auto& node : nodes_) {
      settle(*node, random);
    }
    open_.clear();
    fault_.reset();
    powered_ = true;
  }

  int open(const char* path, int flags) {
    return call([&] { return do_open(path, flags); });
  }
  int close(int fd) {
    return call([&] { return open_.erase(fd) != 0 ? 0 : fail(EBADF); });
  }
  ssize_t read(int fd, void* out, std::size_t size) {
    return call([&]() -> ssize_t {
      Open& file = open_.at(fd);
      const auto& content = nodes_[file.node]->content;
      const std::size_t count = std::min(size, content.size() - file.at);
      std::copy_n(content.data() + file.at, count, static_cast<std::byte*>(out));
      file.at += count;
      return static_cast<ssize_t>(count);
    });
  }
  ssize_t write(int fd, const void* in, std::size_t size, off_t at) {
    const bool part =
        fault_ && fault_->kind == Fault::FaultKind::short_write && fault_->call == calls_;
    const std::size_t count = part ? (size + 1) / 2 : size;
    return call([&]() -> ssize_t {
      auto& content = nodes_[open_.at(fd).node]->content;
      const auto from = static_cast<std::size_t>(at);
      content.resize(std::max(content.size(), from + count));
      std::copy_n(static_cast<const std::byte*>(in), count, content.data() + from);
      return static_cast<ssize_t>(count);
    });
  }
  int fsync(int fd) {
    return call([&] {
      const Open& file = open_.at(fd);
      if (file.folder) {
        durable_names_ = names_;
        pending_.clear();
      } else {
        nodes_[file.node]->durable = nodes_[file.node]->content;
      }
      return 0;
    });
  }
  int rename(const char* from, const char* to) {
    return call([&] {
      const auto found = names_.find(from);
      if (found == names_.end()) {
        return fail(ENOENT);
      }
      const std::size_t node = found->second;
      names_.erase(found);
      names_[to] = node;
      pending_.push_back(names_);
      return 0;
    });
  }
  int lock(int fd) {
    return call([&] {
      const bool taken = std::ranges::any_of(open_, [&](const auto& other) {
        return other.second.locked && other.second.node == open_.at(fd).node;
      });
      if (taken) {
        return fail(EWOULDBLOCK);
      }
      open_.at(fd).locked = true;
      return 0;
    });
  }

 private:
  struct Node {
    std::vector<std::byte> content;
    std::vector<std::byte> durable;
  };
  struct Open {
    std::size_t node = 0;
    std::size_t at = 0;
    bool folder = false;
    bool locked = false;
  };
  using Names = std::map<std::string, std::size_t>;

  static int fail(int error) {
    errno = error;
    return -1;
  }

  template <class Do>
  auto call(Do&& what) -> decltype(what()) {
    if (!powered_) {
      return fail(EIO);
    }
    const bool now = fault_ && fault_->call == calls_;
    ++calls_;
    if (now && fault_->kind == Fault::FaultKind::error) {
      return fail(fault_->error);
    }
    if (now && fault_->kind == Fault::FaultKind::cut_before) {
      powered_ = false;
      return fail(EIO);
    }
    const auto result = what();
    if (now && fault_->kind == Fault::FaultKind::cut_after) {
      powered_ = false;
      return fail(EIO);
    }
    return result;
  }

  int do_open(const std::string& path, int flags) {
    Open file;
    file.folder = path == folder_;
    if (!file.folder && !names_.contains(path)) {
      if ((flags & O_CREAT) == 0) {
        return fail(ENOENT);
      }
      nodes_.push_back(std::make_unique<Node>());
      names_[path] = nodes_.size() - 1;
      pending_.push_back(names_);
    }
    if (!file.folder) {
      file.node = names_.at(path);
      if ((flags & O_TRUNC) != 0) {
        nodes_[file.node]->content.clear();
      }
    }
    int fd = 3;
    while (open_.contains(fd)) {
      ++fd;
    }
    open_[fd] = file;
    return fd;
  }

  static void settle(Node& node, hal::fake::Random& random) {
    const std::uint32_t what = random.below(4);
    if (what == 0) {
      node.content = node.durable;
    } else if (what == 1 && node.content != node.durable) {
      // The length has reached the disk, the last bytes have not.
      const auto same = static_cast<std::size_t>(
          std::ranges::mismatch(node.content, node.durable).in1 - node.content.begin());
      const auto fresh = static_cast<std::uint32_t>(node.content.size() - same);
      const std::size_t kept = same + random.below(fresh + 1);
      std::fill(node.content.begin() + static_cast<std::ptrdiff_t>(kept), node.content.end(),
                std::byte{0});
    } else if (what == 2 && node.content.size() > node.durable.size()) {
      node.content.resize(node.durable.size() + (node.content.size() - node.durable.size()) / 2);
    }
    node.durable = node.content;
  }

  std::string folder_;
  std::vector<std::unique_ptr<Node>> nodes_;
  Names names_;
  Names durable_names_;
  std::vector<Names> pending_;
  std::map<int, Open> open_;
  std::uint64_t calls_ = 0;
  std::optional<Fault> fault_;
  bool powered_ = true;
};

/// The calls of a FileStore, going to a MemoryFiles.
class MemoryCalls {
 public:
  MemoryCalls() = default;
  explicit MemoryCalls(MemoryFiles& files) : files_(&files) {}

  int open(const char* path, int flags) { return files_->open(path, flags); }
  int close(int fd) { return files_->close(fd); }
  ssize_t read(int fd, void* out, std::size_t size) { return files_->read(fd, out, size); }
  ssize_t write(int fd, const void* in, std::size_t size, off_t at) {
    return files_->write(fd, in, size, at);
  }
  int fsync(int fd) { return files_->fsync(fd); }
  int rename(const char* from, const char* to) { return files_->rename(from, to); }
  int lock(int fd) { return files_->lock(fd); }

 private:
  MemoryFiles* files_ = nullptr;
};

static_assert(storage::FileCalls<MemoryCalls>);

}  // namespace storage_test
