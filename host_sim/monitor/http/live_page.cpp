#include "host_sim/monitor/http/live_page.hpp"

#include <httplib.h>
#include <sys/socket.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include "host_sim/io/input_error.hpp"
#include "host_sim/io/system_error_text.hpp"
#include "host_sim/monitor/http/gate.hpp"
#include "host_sim/monitor/http/hub.hpp"
#include "host_sim/monitor/http/routes.hpp"

namespace host_sim::monitor {
namespace {

/// Every reader of events holds a thread; the rest are for short answers.
constexpr std::size_t kThreads = 32;
constexpr std::size_t kMostReaders = 20;

/// A port belongs to one server alone, and what a slow reader has not taken stays small.
void set_socket_options(socket_t socket) {
  const int yes = 1;
  const int most_unsent_bytes = 128 * 1024;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &most_unsent_bytes, sizeof most_unsent_bytes);
}

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
    server.stop();
    thread.join();
  }

  void set_up(const FrameArchive* archive) {
    server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server.set_socket_options(set_socket_options);
    server.set_tcp_nodelay(true);
    server.set_keep_alive_max_count(1000);
    server.set_keep_alive_timeout(2);
    server.set_write_timeout(std::chrono::seconds(10));
    server.set_payload_max_length(0);
    routes::guard(server, gate);
    routes::files(server);
    routes::events(server, hub, kMostReaders);
    routes::views(server, hub);
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
  }

  Address address;
  Gate gate;
  Hub hub;
  httplib::Server server;
  std::thread thread;
};

LivePage::LivePage(const LivePageOptions& options) : impl_(std::make_unique<Impl>(options)) {}

LivePage::~LivePage() = default;

void LivePage::publish(const FleetView& view) {
  impl_->hub.offer(view);
}

std::string LivePage::url() const {
  return "http://" + impl_->address.text() + "/";
}

std::uint16_t LivePage::port() const {
  return impl_->address.port;
}

}  // namespace host_sim::monitor
