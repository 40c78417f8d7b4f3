#pragma once

#include <httplib.h>

#include "host_sim/monitor/http/gate.hpp"
#include "host_sim/monitor/http/hub.hpp"
#include "host_sim/monitor/record/frame_archive.hpp"

/// What the server answers. What is handed over outlives the server's threads.
namespace host_sim::monitor::routes {

/// Headers of every answer, and who may have one.
void guard(httplib::Server& server, const Gate& gate);
/// The page and its parts.
void files(httplib::Server& server);
/// /events, for at most `most_readers` at once.
void events(httplib::Server& server, Hub& hub, std::size_t most_readers);
/// /api/.. and /healthz
void views(httplib::Server& server, const Hub& hub);
/// /api/times and /api/moment/..
void past(httplib::Server& server, const Hub& hub, const FrameArchive& archive);
/// /export/..
void exports(httplib::Server& server, const Hub& hub, const FrameArchive& archive);

}  // namespace host_sim::monitor::routes
