#include "host_sim/monitor/http/live_page.hpp"

#include <httplib.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <compare>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/http/hub.hpp"
#include "host_sim/monitor/http/routes.hpp"

namespace host_sim::monitor {

using hal::files::InputError;
using hal::files::reason_of;

namespace {

using Clock = std::chrono::steady_clock;

/// Every connection holds a thread; a few are there for those that have to go.
constexpr std::size_t kMostConnections = 56;
constexpr std::size_t kThreads = kMostConnections + 8;
constexpr std::size_t kMostReaders = 20;  ///< of events
constexpr std::chrono::seconds kMostForRequest{5};
constexpr std::chrono::seconds kMostIdle{2};
constexpr std::chrono::seconds kMostForWrite{10};

/// A port belongs to one server alone, and what a slow reader has not taken stays small.
void set_socket_options(socket_t socket) {
  const int yes = 1;
  const int most_unsent_bytes = 128 * 1024;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &most_unsent_bytes, sizeof most_unsent_bytes);
}

/// Whether one of `events` was there by `latest`.
bool wait_for(socket_t socket, short events, Clock::time_point latest) {
  ::pollfd waiting{.fd = socket, .events = events, .revents = 0};
  int result = -1;
  do {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(latest - Clock::now()).count();
    result = ::poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(left, 0)));
  } while (result < 0 && errno == EINTR);
  return result > 0;
}

/// A connection whose requests have to be whole in time, however many bytes keep coming.
class Connection final : public httplib::Stream {
 public:
  explicit Connection(socket_t socket) : socket_(socket) {}

  /// Whether another request begins in time; it is then to be whole within kMostForRequest.
  [[nodiscard]] bool begin_request() {
    const bool begun = at_ < end_ || wait_for(socket_, POLLIN, Clock::now() + kMostIdle);
    latest_ = Clock::now() + kMostForRequest;
    return begun;
  }

  [[nodiscard]] bool is_readable() const override {
    return at_ < end_ || wait_for(socket_, POLLIN, latest_);
  }
  [[nodiscard]] bool is_writable() const override {
    return wait_for(socket_, POLLOUT, Clock::now() + kMostForWrite);
  }
  ssize_t read(char* data, std::size_t size) override {
    if (at_ == end_) {
      const ssize_t count =
          is_readable() ? ::recv(socket_, bytes_.data(), bytes_.size(), 0) : ssize_t{-1};
      if (count <= 0) {
        return count;
      }
      at_ = 0;
      end_ = static_cast<std::size_t>(count);
    }
    const std::size_t count = std::min(size, end_ - at_);
    std::copy_n(bytes_.data() + at_, count, data);
    at_ += count;
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* data, std::size_t size) override {
    return is_writable() ? ::send(socket_, data, size, MSG_NOSIGNAL) : ssize_t{-1};
  }
  void get_remote_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  void get_local_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  [[nodiscard]] socket_t socket() const override { return socket_; }

 private:
  socket_t socket_;
  Clock::time_point latest_{};
  std::array<char, 4096> bytes_{};
  std::size_t at_ = 0;
  std::size_t end_ = 0;
};

/// A server whose connections are bounded: where there is no room for one more, the one goes that
/// has kept the server waiting longest, so that slow ones keep nobody out.
class Server final : public httplib::Server {
 public:
  /// More may wait to be taken than the library lets; after it is bound.
  void widen_queue() { ::listen(svr_sock_, static_cast<int>(2 * kMostConnections)); }
  /// Ends all connections, also those that come yet.
  void close_all() {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    for (const auto& [socket, state] : open_) {
      ::shutdown(socket, SHUT_RDWR);
    }
  }

 private:
  /// In the order in which they go, where there are too many.
  enum class Doing : std::uint8_t { nothing, answer, events };
  struct State {
    Doing doing = Doing::nothing;
    Clock::time_point since{};
    friend auto operator<=>(const State&, const State&) = default;
  };

  bool process_and_close_socket(socket_t socket) override {
    const bool taken = open(socket);
    Connection connection(socket);
    bool good = taken;
    for (std::size_t left = keep_alive_max_count_; good && left > 0; --left) {
      is(socket, Doing::nothing);
      bool closed = false;
      good =
          connection.begin_request() &&
          process_request(connection, left == 1, closed,
                          [&](httplib::Request& request) {
                            request.ranges.clear();  // RFC 9110, 14.2: a server may ignore them
                            is(socket, request.path == "/events" ? Doing::events : Doing::answer);
                          }) &&
          !closed;
    }
    close(socket);
    return good;
  }

  bool open(socket_t socket) {
    const std::lock_guard lock(mutex_);
    if (closing_) {
      return false;
    }
    if (open_.size() >= kMostConnections) {
      const auto first = std::min_element(open_.begin(), open_.end(), [](auto& one, auto& other) {
        return one.second < other.second;
      });
      ::shutdown(first->first, SHUT_RDWR);
      open_.erase(first);
    }
    open_[socket] = {Doing::nothing, Clock::now()};
    return true;
  }

  void is(socket_t socket, Doing doing) {
    const std::lock_guard lock(mutex_);
    if (const auto found = open_.find(socket); found != open_.end()) {
      found->second = {doing, Clock::now()};
    }
  }

  void close(socket_t socket) {
    const std::lock_guard lock(mutex_);
    open_.erase(socket);
    ::shutdown(socket, SHUT_RDWR);
    ::close(socket);
  }

  std::mutex mutex_;
  std::map<socket_t, State> open_;
  bool closing_ = false;
};

}  // namespace

struct LivePage::Impl {
  explicit Impl(const LivePageOptions& options)
      : address(options.address), gate(options.address, options.token) {
    set_up(options.archive);
    bind();
    gate.listens_at(address.port);
    thread = std::thread([this] { server.listen_after_bind(); });
    while (!server.is_running()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    hub.close();
    server.close_all();
    server.stop();
    thread.join();
  }

  void set_up(const FrameArchive& archive) {
    server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server.set_socket_options(set_socket_options);
    server.set_tcp_nodelay(true);
    server.set_keep_alive_max_count(1000);
    server.set_payload_max_length(0);
    routes::guard(server, gate);
    routes::files(server);
    routes::events(server, hub, kMostReaders);
    routes::views(server, hub);
    routes::past(server, hub, archive);
    routes::exports(server, hub, archive);
  }

  void bind() {
    int port = address.port;
    if (port == 0) {
      port = server.bind_to_any_port(address.host);
    } else if (!server.bind_to_port(address.host, port)) {
      port = -1;
    }
    if (port < 0) {
      const std::string why = reason_of(errno);
      throw InputError("--http", 0, 0, "'" + address.text() + "', where it cannot listen: " + why,
                       "an address of this machine and a port that is free");
    }
    address.port = static_cast<std::uint16_t>(port);
    server.widen_queue();
  }

  Address address;
  Gate gate;
  Hub hub;
  Server server;
  std::thread thread;
};

LivePage::LivePage(const LivePageOptions& options) : impl_(std::make_unique<Impl>(options)) {}

LivePage::~LivePage() = default;

void LivePage::update(const FleetView& view) {
  impl_->hub.offer(view);
}

std::string LivePage::url() const {
  return "http://" + impl_->address.text() + "/";
}

std::uint16_t LivePage::port() const {
  return impl_->address.port;
}

}  // namespace host_sim::monitor
