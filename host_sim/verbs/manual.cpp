#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "host_sim/command_line/manual_page.hpp"
#include "host_sim/command_line/quote.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

constexpr const char* kDescription =
    R"roff(Bowden cables break by fatigue, at the motor end, where friction amplifies the load.
.B host_sim
says how much of a tendon's life a recorded load uses, fits the life model to specimens that were run
to failure, finds out why recordings and model disagree, plans such tests, and watches the controllers
that count the life of their tendons.
Recorded loads run through the very code that runs on a controller.
.PP
Each verb prints a short summary for people.
.B \-\-json
writes the whole result for programs,
.B \-\-report
a page with plots that needs no network.
A value of
.B \-
stands for standard input or standard output.
Files are written whole or not at all.
The same input and the same
.B \-\-seed
give the same bytes, for any number of threads.
.PP
Damage is the share of the life of a tendon that is used up; 1 is the characteristic life.
B10 is the life that one tendon in ten does not reach.
)roff";

constexpr const char* kAfterVerbs = R"roff(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
Bad input.
Standard error says file, line and column, what was found and what is accepted.
Or an output could not be written.
.TP
.B 2
Wrong usage.
.TP
.B 3
The data have what the run was asked to fail on:
.BR \-\-fail\-on ,
.BR \-\-fail\-on\-discrepancy ,
or a node that needs attention with
.BR "monitor \-\-once" .
.TP
.B 130
Interrupted.
.SH FILES
.TP
.I model.toml
The model: cable, sheath, drive, counting and life.
.TP
.I profile.csv
A recorded load.
The header names the columns with their units; lines that begin with # are comments.
.TP
.I campaign.toml, specimens.csv, blocks.csv, sessions.csv
A campaign, which is a folder: lives of specimens, recordings, or both.
.TP
.I @DOCUMENTS@/host_sim/README.md
All of these, key by key and column by column.
.TP
.I @DOCUMENTS@/examples
Examples of each.
)roff";

constexpr const char* kSeeAlso = R"roff(.BR candump (1),
.BR canplayer (1),
.BR slcand (1),
.BR tendonlife_controller (8)
.PP
Logs of
.B replay \-\-can
and
.B monitor \-\-record
are those of
.BR "candump \-L" ,
and
.B canplayer
plays them on a bus.
)roff";

/// What the manual page of host_sim says beyond its options. @param documents the folder of the
/// installed documentation
command_line::ManualProse manual_prose(const std::string& documents) {
  return {
      kDescription,
      command_line::replace_all(kAfterVerbs, "@DOCUMENTS@", command_line::roff_literal(documents)),
      kSeeAlso};
}

}  // namespace

void add_manual(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand("manual", "The manual page, as roff");
  verb->footer("Example: host_sim manual | man -l -");
  verb->callback([&app] {
    const std::string documents = TENDONLIFE_DOCUMENTS;
    std::cout << command_line::manual_page(
        command_line::read_command(app), {std::string(kProgramVersion), TENDONLIFE_RELEASE_DATE},
        manual_prose(documents), "host_sim/examples", documents + "/examples");
  });
}

}  // namespace host_sim
