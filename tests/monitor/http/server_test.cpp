#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/http/live_page.hpp"
#include "tests/monitor/http/made_view.hpp"

namespace host_sim::monitor {

using hal::files::InputError;

namespace {

using nlohmann::json;

class TwoLines : public FrameArchive {
 public:
  void read_from(std::int64_t, const std::function<bool(std::string_view)>& take) const override {
    take("(8.000000) can0 705#05\n(9.000000) can0 705#05\n");
  }
  [[nodiscard]] std::vector<std::int64_t> times_us() const override { return {8'000'000}; }
  [[nodiscard]] std::string why_gone() const override { return "two lines are kept"; }
  void read(std::optional<protocol::Node> node,
            const std::function<bool(std::string_view)>& take) const override {
    take(node ? "of a node\n" : "of all\n") && take("second\n");
  }
};

/// A page on a free port with a view, and a client.
class Served {
 public:
  explicit Served(std::optional<std::string> token = {}) : Served(std::move(token), nothing()) {}
  Served(std::optional<std::string> token, const FrameArchive& archive)
      : page({{"127.0.0.1", 0}, archive, std::move(token)}), client("127.0.0.1", page.port()) {
    page.update(test::made_view());
    while (!token_is_needed() && !client.Get("/api/fleet")->body.size()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  [[nodiscard]] bool token_is_needed() { return client.Get("/api/fleet")->status == 401; }

  static const FrameArchive& nothing() {
    static const RecentFrames none("can0");
    return none;
  }

  LivePage page;
  httplib::Client client;
};

const std::string kPageToken = "abcdefgh12345678";

TEST(Server, ServesThePageWithoutOutsideResources) {
  Served served;
  const auto page = served.client.Get("/");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  const std::string policy = page->get_header_value("Content-Security-Policy");
  EXPECT_TRUE(policy.starts_with("default-src 'none'; script-src 'self';")) << policy;
  EXPECT_EQ(page->body.find("http://"), std::string::npos);
  EXPECT_EQ(page->body.find("https://"), std::string::npos);
  for (std::size_t at = page->body.find("\"/assets/"); at != std::string::npos;
       at = page->body.find("\"/assets/", at + 1)) {
    const std::string name = page->body.substr(at + 1, page->body.find('"', at + 1) - at - 1);
    EXPECT_EQ(served.client.Get(name)->status, 200) << name;
  }
  EXPECT_EQ(served.client.Get("/assets/none.js")->status, 404);
  EXPECT_EQ(served.client.Get("/assets/../live_page.cpp")->status, 404);
}

TEST(Server, AnswersToLoopbackNamesAlone) {
  Served served;
  EXPECT_EQ(served.client.Get("/api/fleet", {{"Host", "evil.org"}})->status, 403);
  EXPECT_EQ(served.client.Get("/events", {{"Host", "evil.org"}})->status, 403);
  EXPECT_EQ(served.client.Get("/api/fleet", {{"Host", "localhost:80"}})->status, 200);
}

TEST(Server, AnswersNoPageOfAnotherSite) {
  Served served;
  const auto ask = [&](const char* site, const char* mode) {
    return served.client.Get("/api/fleet", {{"Sec-Fetch-Site", site}, {"Sec-Fetch-Mode", mode}})
        ->status;
  };
  EXPECT_EQ(ask("cross-site", "cors"), 403);
  EXPECT_EQ(ask("cross-site", "no-cors"), 403);
  EXPECT_EQ(ask("cross-site", "navigate"), 200);
  EXPECT_EQ(ask("same-origin", "cors"), 200);
  EXPECT_EQ(ask("none", "navigate"), 200);
}

TEST(Server, TellsTheFleetAndANode) {
  Served served;
  EXPECT_EQ(json::parse(served.client.Get("/api/fleet")->body)["nodes"].size(), 1u);
  const json node = json::parse(served.client.Get("/api/node/5")->body);
  EXPECT_EQ(node["status"]["Damage"], 0.123456789);
  EXPECT_EQ(node["curve"].size(), 2u);
  EXPECT_EQ(served.client.Get("/api/node/6")->status, 404);
  EXPECT_EQ(served.client.Get("/api/node/261")->status, 404);
  EXPECT_EQ(served.client.Get("/healthz")->status, 200);
}

TEST(Server, ExportsWhatWasRecorded) {
  const TwoLines log;
  Served served({}, log);
  const auto csv = served.client.Get("/export/5.csv");
  EXPECT_EQ(csv->body.substr(0, 7), "time_s,");
  EXPECT_EQ(csv->get_header_value("Content-Disposition"), "attachment; filename=\"node-5.csv\"");
  EXPECT_EQ(served.client.Get("/export/5.candump")->body, "of a node\nsecond\n");
  EXPECT_EQ(served.client.Get("/export/all.candump")->body, "of all\nsecond\n");
  EXPECT_EQ(served.client.Get("/export/6.csv")->status, 404);
  EXPECT_EQ(served.client.Get("/export/6.candump")->status, 404);
}

TEST(Server, TellsMomentsOfThePast) {
  const TwoLines log;
  Served served({}, log);
  EXPECT_EQ(json::parse(served.client.Get("/api/times")->body), json::parse(R"({
      "times_us": [1000000, 8000000], "whole_from_us": 8000000, "why_gone": "two lines are kept"})"));
  const json eight = json::parse(served.client.Get("/api/moment/8500000")->body);
  EXPECT_EQ(eight["now_us"], 8'500'000);
  EXPECT_EQ(eight["frames"], 1);
  EXPECT_FALSE(eight.contains("history"));
  const json nine = json::parse(served.client.Get("/api/moment/9000000/5")->body);
  EXPECT_EQ(nine["frames"], 2);
  EXPECT_EQ(nine["nodes"]["5"]["heartbeat"]["time_us"], 9'000'000);
  EXPECT_EQ(nine["history"]["curve"], json::array());
  EXPECT_EQ(served.client.Get("/api/moment/9000000/261")->status, 200);
  EXPECT_EQ(served.client.Get("/api/moment/9999999999999999")->status, 200);
  EXPECT_EQ(served.client.Get("/api/moment/x")->status, 404);
}

class BadLine : public TwoLines {
 public:
  void read_from(std::int64_t, const std::function<bool(std::string_view)>& take) const override {
    take("(8.000000) can0\n");
  }
};

TEST(Server, SaysWhatOfTheRecordCannotBeRead) {
  const BadLine log;
  Served served({}, log);
  const auto answer = served.client.Get("/api/moment/9000000");
  EXPECT_EQ(answer->status, 500);
  EXPECT_TRUE(answer->body.starts_with("the record:1:")) << answer->body;
}

TEST(Server, AsksForItsToken) {
  Served served(kPageToken);
  for (const char* path :
       {"/", "/events", "/api/fleet", "/export/all.candump", "/assets/main.js"}) {
    const auto answer = served.client.Get(path);
    EXPECT_EQ(answer->status, 401) << path;
    EXPECT_EQ(answer->body.find(kPageToken), std::string::npos);
  }
  EXPECT_NE(served.client.Get("/healthz")->status, 401);
  served.client.set_bearer_token_auth(kPageToken);
  EXPECT_EQ(served.client.Get("/")->status, 200);
  served.client.set_bearer_token_auth("abcdefgh12345679");
  EXPECT_EQ(served.client.Get("/")->status, 401);
}

TEST(Server, TurnsATokenOfTheAddressIntoACookie) {
  Served served(kPageToken);
  const auto first = served.client.Get("/?token=" + kPageToken);
  EXPECT_EQ(first->status, 303);
  EXPECT_EQ(first->get_header_value("Location"), "/");
  const std::string cookie = first->get_header_value("Set-Cookie");
  EXPECT_NE(cookie.find("HttpOnly"), std::string::npos);
  const httplib::Headers back = {{"Cookie", cookie.substr(0, cookie.find(';'))}};
  EXPECT_EQ(served.client.Get("/", back)->status, 200);
  EXPECT_EQ(served.client.Get("/?token=" + kPageToken + "x")->status, 401);
}

TEST(Server, StreamsAWholeViewFirst) {
  Served served;
  std::string text;
  served.client.Get("/events", [&](const char* data, std::size_t length) {
    text.append(data, length);
    return text.find("}\n\n") == std::string::npos;
  });
  EXPECT_TRUE(text.starts_with("retry: 1000\n\nevent: whole\ndata: {")) << text;
  const std::size_t start = text.find('{');
  EXPECT_EQ(json::parse(text.substr(start, text.find("\n\n", start) - start))["frames"], 42);
}

TEST(Server, RefusesMoreReadersThanItHasRoomFor) {
  Served served;
  std::atomic<int> reading = 0;
  std::atomic<bool> enough = false;
  std::vector<std::thread> readers;
  for (int i = 0; i < 20; ++i) {
    readers.emplace_back([&] {
      bool first = true;
      httplib::Client client("127.0.0.1", served.page.port());
      client.Get("/events", [&](const char*, std::size_t) {
        reading += std::exchange(first, false) ? 1 : 0;
        return !enough;
      });
    });
  }
  while (reading < 20) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const auto refused = served.client.Get("/events");
  EXPECT_EQ(refused->status, 503);
  EXPECT_EQ(served.client.Get("/api/fleet")->status, 200);
  enough = true;
  for (std::thread& reader : readers) {
    reader.join();
  }
}

/// A connection to this machine that sends `text`, and no more.
int connection_that_sent(std::uint16_t port, std::string_view text) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  ::sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(::connect(socket, reinterpret_cast<const ::sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(::send(socket, text.data(), text.size(), MSG_NOSIGNAL),
            static_cast<ssize_t>(text.size()));
  return socket;
}

/// Much more than the buffers of two sockets hold, as long as somebody takes it.
class EndlessLog : public TwoLines {
 public:
  void read(std::optional<protocol::Node>,
            const std::function<bool(std::string_view)>& take) const override {
    const std::string piece(1 << 20, 'x');
    for (int i = 0; i < 1000 && take(piece); ++i) {
    }
  }
};

// Requests that never end, downloads that nobody reads, and connections that say nothing.
TEST(Server, SlowConnectionsKeepNobodyOut) {
  const EndlessLog log;
  Served served({}, log);
  const std::string host = "Host: 127.0.0.1\r\n";
  std::vector<int> slow;
  for (int i = 0; i < 40; ++i) {
    slow.push_back(connection_that_sent(served.page.port(), "GET / HTTP/1.1\r\n" + host));
    slow.push_back(connection_that_sent(served.page.port(),
                                        "GET /export/all.candump HTTP/1.1\r\n" + host + "\r\n"));
    slow.push_back(connection_that_sent(served.page.port(), ""));
  }
  served.page.update(test::made_view());
  const auto began = std::chrono::steady_clock::now();
  for (const char* path : {"/healthz", "/", "/api/fleet"}) {
    httplib::Client client("127.0.0.1", served.page.port());
    const auto answer = client.Get(path);
    ASSERT_TRUE(answer) << path;
    EXPECT_EQ(answer->status, 200) << path;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(2));
  for (const int socket : slow) {
    ::close(socket);
  }
}

TEST(Server, ARequestThatTakesTooLongIsNotWaitedFor) {
  Served served;
  const int slow = connection_that_sent(served.page.port(), "G");
  const auto began = std::chrono::steady_clock::now();
  while (::send(slow, "E", 1, MSG_NOSIGNAL) == 1 &&
         std::chrono::steady_clock::now() - began < std::chrono::seconds(20)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(8));
  ::close(slow);
}

TEST(Server, IgnoresRanges) {
  Served served(kPageToken);
  std::string ranges = "bytes=0-";
  for (int i = 1; i < 2600; ++i) {
    ranges += ",0-";
  }
  for (const std::string& range : {std::string("bytes=1-2"), ranges}) {
    const auto refused = served.client.Get("/", {{"Range", range}});
    EXPECT_EQ(refused->status, 401);
    EXPECT_LT(refused->body.size(), 200u);
    const auto whole =
        served.client.Get("/", {{"Authorization", "Bearer " + kPageToken}, {"Range", range}});
    EXPECT_EQ(whole->status, 200);
    EXPECT_TRUE(whole->body.starts_with("<!DOCTYPE html>"));
    EXPECT_LT(whole->body.size(), 100'000u);
  }
}

TEST(Server, RefusesAPortThatIsTaken) {
  Served served;
  EXPECT_THROW(LivePage({{"127.0.0.1", served.page.port()}, Served::nothing()}), InputError);
}

TEST(Server, RefusesAnOpenAddressWithoutToken) {
  EXPECT_THROW(LivePage({{"0.0.0.0", 0}, Served::nothing()}), InputError);
}

TEST(Server, EndsWhileOneReads) {
  auto served = std::make_unique<Served>();
  std::atomic<bool> reading = false;
  const std::uint16_t port = served->page.port();
  std::thread reader([&] {
    httplib::Client client("127.0.0.1", port);
    client.Get("/events", [&](const char*, std::size_t) { return reading = true; });
  });
  while (!reading) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  served.reset();
  reader.join();
}

}  // namespace
}  // namespace host_sim::monitor
