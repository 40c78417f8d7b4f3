// What holds of every verb, whatever it does.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tests/replay/interrupted.hpp"
#include "tests/verbs/campaign_program.hpp"

namespace {

using host_sim_test::CampaignProgram;
using host_sim_test::contents;
using Names = std::vector<std::string>;
namespace fs = std::filesystem;

/// A command line that reads, without its outputs.
struct Verb {
  std::string name;
  std::string arguments;
  Names reads;   ///< files
  Names writes;  ///< options that name a file
  Names fills;   ///< options that name a folder
  Names by;      ///< options and arguments that name what is read
};

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> all{
      {"replay",
       "good.csv --model model.toml",
       {"good.csv", "model.toml"},
       {"--json", "--trajectory", "--report", "--can", "--specimens"},
       {},
       {"PROFILE", "--model"}},
      {"replay",
       "logs --model model.toml",
       {"logs/a.csv", "logs/b/c.csv", "model.toml"},
       {"--json", "--table", "--specimens"},
       {},
       {}},
      {"replay", "logs", {"logs/a.csv", "logs/model.toml"}, {"--json", "--table"}, {}, {}},
      {"calibrate",
       "c",
       {"c/campaign.toml", "c/specimens.csv", "c/blocks.csv", "c/sessions.csv"},
       {"--out", "--json", "--report"},
       {},
       {"CAMPAIGN"}},
      {"calibrate",
       "all --batch",
       {"all/c/campaign.toml", "all/c/specimens.csv"},
       {"--table"},
       {},
       {}},
      {"calibrate", "all --batch --table t.csv", {"all/c/specimens.csv"}, {"--json"}, {}, {}},
      {"compare",
       "good.csv logs/a.csv --model model.toml",
       {"good.csv", "logs/a.csv", "model.toml"},
       {"--json", "--report"},
       {},
       {"A", "B", "--model"}},
      {"compare",
       "model.toml elsewhere/other.toml --profile good.csv",
       {"model.toml", "elsewhere/other.toml", "good.csv"},
       {"--json", "--report"},
       {},
       {"A", "B", "--profile"}},
      {"design",
       "--model model.toml --tension 49",
       {"model.toml"},
       {"--json", "--table", "--report"},
       {},
       {"--model"}},
      {"diagnose",
       "r",
       {"r/campaign.toml", "r/specimens.csv", "r/blocks.csv", "r/sessions.csv", "r/one.csv",
        "r/deep/two.csv"},
       {"--out", "--json", "--report"},
       {},
       {"CAMPAIGN"}},
      {"plan",
       "--model model.toml --levels 42.5,55 --use-tension 38 --specimens 3,3 --simulations 100",
       {"model.toml"},
       {"--json", "--report"},
       {},
       {"--model"}},
      {"plan", "--for-diagnosis plan.toml", {"plan.toml"}, {"--json"}, {}, {"--for-diagnosis"}},
      {"fleet",
       "fleet.csv --model model.toml",
       {"fleet.csv", "model.toml", "elsewhere/other.toml"},
       {"--table", "--json", "--calendar", "--report", "--write-table"},
       {},
       {"TENDONS", "--model"}},
      {"synth",
       "--plan plan.toml",
       {"plan.toml"},
       {"--out new --truth", "--out new --json"},
       {"--force --out"},
       {"--plan"}},
      {"init", "plan", {}, {"--out"}, {}, {}},
      {"pack", "model.toml", {"model.toml"}, {"--out"}, {}, {"MODEL"}},
      {"fmeca",
       "fmeca.toml --field field.csv",
       {"fmeca.toml", "field.csv"},
       {"--json", "--table", "--report"},
       {},
       {"TABLE", "--field"}},
      {"import davinci", "good.csv", {"good.csv"}, {}, {"--out"}, {"FILE"}},
      {"import columns",
       "good.csv r/one.csv --column input_tension_N=output_tension_N --column "
       "\"rate(input_tension_N)=tendon_velocity_m_s\"",
       {"good.csv", "r/one.csv"},
       {},
       {"--out"},
       {"FILE"}},
      {"monitor", "--once --log logs/a.csv", {"logs/a.csv"}, {}, {"--record"}, {"--log"}},
      {"monitor",
       "--once --log logs/a.csv --model model.toml",
       {"logs/a.csv", "model.toml"},
       {"--specimens"},
       {},
       {"--log", "--model"}},
  };
  return all;
}

std::string last_word(const std::string& text) {
  return text.substr(text.rfind(' ') + 1);
}

class EveryVerb : public CampaignProgram {
 protected:
  void SetUp() override {
    CampaignProgram::SetUp();
    const std::string profile = contents(folder_ / "good.csv");
    const std::string model = contents(folder_ / "model.toml");
    for (const char* const name : {"logs/b", "all", "r/deep", "elsewhere"}) {
      fs::create_directories(folder_ / name);
    }
    fs::create_directory_symlink(".", folder_ / "here");
    for (const char* const name : {"logs/a.csv", "logs/b/c.csv"}) {
      write(name, profile);
    }
    write("logs/model.toml", model);
    write("fmeca.toml", contents(fs::path(EXAMPLES) / "fmeca/soft_robot.toml"));
    write("field.csv", contents(fs::path(EXAMPLES) / "fmeca/field.csv"));
    write("plan.toml", contents(fs::path(EXAMPLES) / "synth/lives.toml"));
    std::string recording = "time_s,input_tension_N,output_tension_N,tendon_velocity_m_s\n";
    for (int i = 0; i < 16; ++i) {
      recording += std::to_string(i) + ",3,2,1\n";
    }
    write("elsewhere/other.toml", model);
    write("fleet.csv",
          "tendon,damage,damage_per_h,hours_per_day,model\na,0.1,1e-3,8,elsewhere/other.toml\n"
          "b,0.1,1e-3,8,\n");
    write("r/one.csv", recording);
    write("r/deep/two.csv", recording);
    write_campaign("all/c", specimens());
    write("r/campaign.toml", toml() +
                                 "\n[model.life]\nmean_stress = \"gerber\"\nipl_scale = 1.53e5\n"
                                 "ipl_exponent = 1.38\nweibull_shape = 5.94\n");
    write("r/sessions.csv",
          "session,specimen,file,start_cycle\n1,a,one.csv,0\n2,a,deep/../deep/two.csv,0\n");
  }

  /// All files, by what they hold.
  [[nodiscard]] std::map<std::string, std::string> snapshot() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      all[entry.path().string()] = entry.is_regular_file() ? contents(entry.path()) : "";
    }
    return all;
  }

  /// Other names of a file, or of one that is not there.
  [[nodiscard]] Names aliases(const std::string& file) {
    Names names{file, "./" + file, (folder_ / file).string(), "here/" + file,
                "elsewhere/../here/" + file};
    if (fs::exists(folder_ / file)) {
      const std::string number = std::to_string(++links_);
      fs::create_symlink(folder_ / file, folder_ / ("elsewhere/soft" + number));
      fs::create_hard_link(folder_ / file, folder_ / ("elsewhere/hard" + number));
      names.push_back("elsewhere/soft" + number);
      names.push_back("elsewhere/hard" + number);
    }
    return names;
  }

  void expect_refused(const std::string& command, int status, const std::string& words) {
    const auto before = snapshot();
    EXPECT_EQ(run(command), status) << command << '\n' << err_;
    EXPECT_NE(err_.find(words), std::string::npos) << command << '\n' << err_;
    EXPECT_EQ(out_, "") << command;
    EXPECT_TRUE(snapshot() == before) << command;
  }

  /// What of `type` the help of a verb lists.
  std::set<std::string> listed(const std::string& verb, const std::string& type) {
    EXPECT_EQ(run(verb + " --help"), 0);
    std::set<std::string> found;
    const std::regex line("\n  (\\S+) (" + type + ")[ \n]");
    for (std::sregex_iterator at(out_.begin(), out_.end(), line), end; at != end; ++at) {
      found.insert((*at)[1]);
    }
    return found;
  }

  /// Starts `command`, a line for a shell, and gives its process.
  [[nodiscard]] pid_t start(const std::string& command) const {
    const pid_t process = ::fork();
    if (process == 0) {
      const std::string line = "cd '" + folder_.string() + "' && exec " + command;
      ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      ::_exit(99);
    }
    return process;
  }

  /// Until the program sleeps, three looks in a row: with its handlers set, on what it waits for.
  /// Ten seconds at the most.
  static void await_sleep(pid_t process) {
    const fs::path of = fs::path("/proc") / std::to_string(process);
    int asleep = 0;
    for (int i = 0; i < 500 && asleep < 3; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      const bool sleeps = contents(of / "stat").find(" (host_sim) S ") != std::string::npos;
      asleep = sleeps ? asleep + 1 : 0;
    }
  }

  /// -1 where it does not end within ten seconds.
  static int status_of(pid_t process) {
    int status = 0;
    for (int i = 0; i < 1000; ++i) {
      if (::waitpid(process, &status, WNOHANG) == process) {
        return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ::kill(process, SIGKILL);
    ::waitpid(process, &status, 0);
    return -1;
  }

 private:
  int links_ = 0;
};

TEST_F(EveryVerb, IsKnownHereWithAllOfItsFiles) {
  std::map<std::string, std::set<std::string>> named;
  for (const Verb& verb : verbs()) {
    for (const Names& options : {verb.writes, verb.fills, verb.by}) {
      for (const std::string& option : options) {
        named[verb.name].insert(last_word(option));
      }
    }
  }
  for (const auto& [verb, options] : named) {
    EXPECT_EQ(listed(verb, "FILE|FOLDER"), options) << verb;
  }
  EXPECT_EQ(run("--help"), 0);
  const std::regex verb_line("\n  ([a-z]+) ");
  const std::string help = out_.substr(out_.find("Subcommands:"));
  for (std::sregex_iterator at(help.begin(), help.end(), verb_line), end; at != end; ++at) {
    const std::string name = (*at)[1];
    EXPECT_TRUE(name == "manual" || name == "completion" || name == "import" || name == "help" ||
                name == "schema" || named.contains(name))
        << name;
  }
}

TEST_F(EveryVerb, AnOutputInPlaceOfWhatIsReadIsRefused) {
  for (const Verb& verb : verbs()) {
    for (const std::string& file : verb.reads) {
      const Names names = aliases(file);
      for (std::size_t i = 0; i < std::max(names.size(), verb.writes.size()); ++i) {
        if (verb.writes.empty()) {
          continue;
        }
        const std::string& alias = names[i % names.size()];
        const std::string& option = verb.writes[i % verb.writes.size()];
        expect_refused(verb.name + " " + verb.arguments + " " + option + " " + alias, 1,
                       alias + ": " + last_word(option) + " would overwrite '");
      }
    }
  }
}

TEST_F(EveryVerb, AFolderThatIsWrittenHoldsNothingThatIsRead) {
  for (const Verb& verb : verbs()) {
    for (const std::string& option : verb.fills) {
      for (const std::string& folder : Names{".", "here", folder_.string(), "elsewhere/.."}) {
        expect_refused(verb.name + " " + verb.arguments + " " + option + " " + folder, 1,
                       folder + ": " + last_word(option) + " would overwrite '");
      }
    }
  }
}

TEST_F(EveryVerb, TwoOutputsAreTwoFiles) {
  write("there.json", "{}");
  fs::create_hard_link(folder_ / "there.json", folder_ / "hard.json");
  const std::vector<std::pair<std::string, std::string>> same{
      {"new.json", "new.json"},
      {"new.json", "./new.json"},
      {"here/new.json", "new.json"},
      {(folder_ / "new.json").string(), "new.json"},
      {"elsewhere/../new.json", "new.json"},
      {"there.json", "hard.json"},
      {"-", "-"}};
  for (const Verb& verb : verbs()) {
    for (std::size_t one = 0; one < verb.writes.size(); ++one) {
      for (std::size_t other = one + 1; other < verb.writes.size(); ++other) {
        for (const auto& [first, second] : same) {
          std::string command = verb.name + " " + verb.arguments + " " + verb.writes[one] + " " +
                                first + " " + last_word(verb.writes[other]) + " " + second;
          expect_refused(command, 2, "two outputs go to '");
        }
      }
    }
  }
}

TEST_F(EveryVerb, TheStandardStreamsAreFilesAsWell) {
  const auto before = snapshot();
  const std::string cd = "cd '" + folder_.string() + "' && '" HOST_SIM "' ";
  const std::vector<std::string> commands{
      "replay - --model model.toml --report good.csv < good.csv 2> /dev/null",
      "replay good.csv --model model.toml --json r.json >> good.csv 2> /dev/null",
      "pack - --out model.toml < model.toml 2> /dev/null",
      "pack model.toml --out - 2> /dev/null >> model.toml"};
  for (const std::string& command : commands) {
    EXPECT_EQ(WEXITSTATUS(std::system((cd + command).c_str())), 1) << command;
    EXPECT_TRUE(snapshot() == before) << command;
  }
  EXPECT_EQ(run("replay good.csv --model model.toml --json /dev/null --report /dev/null"), 0);
}

TEST_F(EveryVerb, AClosedStandardOutputIsNotTheNextFile) {
  const std::string command = "cd '" + folder_.string() +
                              "' && '" HOST_SIM
                              "' replay good.csv --model model.toml --json r.json >&- 2> err.txt";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  EXPECT_EQ(contents(folder_ / "err.txt"),
            "standard output: cannot be written: Bad file descriptor\n");
  EXPECT_EQ(contents(folder_ / "r.json").rfind("{", 0), 0U);
}

TEST_F(EveryVerb, ASummaryThatCannotBeWrittenIsAnError) {
  write("c.log", "(0.000000) can0 123#00\n");
  const std::string full = "standard output: cannot be written: No space left on device\n";
  for (const std::string command :
       {"replay good.csv --model model.toml", "replay logs --table t.csv", "calibrate c",
        "calibrate all --batch --table t2.csv", "monitor --log c.log --once", "manual",
        "completion bash", "--help", "replay --help", "--version",
        "plan --scale 1.53e5 --exponent 1.38 --shape 5.94 --levels 42.5,55 --use-tension 38 "
        "--specimens 3,3 --simulations 100"}) {
    const std::string line =
        "cd '" + folder_.string() + "' && '" HOST_SIM "' " + command + " > /dev/full 2> err.txt";
    EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 1) << command;
    EXPECT_EQ(contents(folder_ / "err.txt"), full) << command;
  }
}

TEST_F(EveryVerb, ANameThatIsTooLongIsToldAsSuch) {
  const std::string name(300, 'n');
  for (const Verb& verb : verbs()) {
    for (const std::string& option : verb.writes) {
      expect_refused(verb.name + " " + verb.arguments + " " + option + " " + name, 1,
                     name + ": cannot be written: its name has 300 bytes; accepted: 255 at most");
    }
  }
  expect_refused("replay " + name + " --model model.toml", 1, name + ": cannot be opened: File");
  expect_refused("diagnose " + name, 1, "cannot be opened: File name too long; accepted: ");
  const std::string long_name(255, 'n');
  EXPECT_EQ(run("pack model.toml --out " + long_name), 0) << err_;
  EXPECT_EQ(contents(folder_ / long_name).size(), 84U);
}

TEST_F(EveryVerb, ANumberIsOne) {
  std::size_t numbers = 0;
  std::set<std::string> names{"import davinci", "import columns"};
  for (const Verb& verb : verbs()) {
    names.insert(verb.name);
  }
  for (const std::string& verb : names) {
    std::set<std::string> options = listed(verb, "(?:UINT|INT|FLOAT)(?:[:=]\\S*)?");
    if (verb == "monitor") {
      options.insert("--replay-speed");
    }
    for (const std::string& option : options) {
      ++numbers;
      for (const std::string value : {"nan", "-nan", "NAN", "inf", "-inf", "1e999", "1,nan"}) {
        EXPECT_EQ(run(verb + " " + option + "=" + value), 2) << option << value;
        EXPECT_NE(err_.find(option), std::string::npos) << option << value << err_;
        const bool range = err_.find(" not in range nan") == std::string::npos;
        EXPECT_TRUE(range && err_.find("required") == std::string::npos) << option << value << err_;
      }
    }
  }
  EXPECT_GE(numbers, 30U);
}

TEST_F(EveryVerb, TomlThatIsTooDeepIsRefusedWithItsPlace) {
  std::string deep = "[a";
  for (int i = 0; i < 31'000; ++i) {
    deep += ".a";
  }
  deep += "]\n";
  std::set<std::string> files;
  for (const Verb& verb : verbs()) {
    for (const std::string& file : verb.reads) {
      if (fs::path(file).extension() != ".toml") {
        continue;
      }
      const std::string text = contents(folder_ / file);
      write(file, deep);
      const std::string outputs = verb.writes.empty() ? "" : " " + verb.writes.back() + " x.out";
      EXPECT_EQ(run(verb.name + " " + verb.arguments + outputs), 1) << verb.name << file;
      EXPECT_NE(err_.find(file + ":1:65: more than 32 levels; accepted: "), std::string::npos)
          << verb.name << file << err_;
      fs::remove(folder_ / "x.out");
      write(file, text);
      files.insert(file);
    }
  }
  EXPECT_EQ(files.size(), 8U);
}

TEST_F(EveryVerb, ADeepModelDoesNotStopTheOtherProfilesOfAFolder) {
  write("logs/b/model.toml", "a = " + std::string(40, '[') + std::string(40, ']'));
  EXPECT_EQ(run("replay logs --table t.csv"), 1);
  EXPECT_NE(out_.find("1 profiles replayed, 1 refused"), std::string::npos) << out_;
  EXPECT_EQ(err_,
            "logs/b/model.toml:1:36: more than 32 levels; accepted: TOML of at most 32 levels\n");
}

TEST_F(EveryVerb, ASignalEndsWhatWaitsForAPipe) {
  ASSERT_EQ(::mkfifo((folder_ / "fifo").c_str(), 0600), 0);
  const auto before = snapshot();
  const std::string log = " 2> /dev/null > /dev/null";
  const std::string program = "'" HOST_SIM "' ";
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    for (const std::string command :
         {"replay fifo --model model.toml --json r.json", "replay good.csv --model fifo",
          "pack fifo --out b.bin", "pack model.toml --out fifo",
          "replay good.csv --model model.toml --report p.html --trajectory fifo"}) {
      const pid_t process = start(program + command + log);
      await_sleep(process);
      ::kill(process, signal);
      EXPECT_EQ(status_of(process), 130) << command << signal;
      EXPECT_TRUE(snapshot() == before) << command << signal;
    }
  }
}

TEST_F(EveryVerb, AFifoIsReadAndWritten) {
  ASSERT_EQ(::mkfifo((folder_ / "in").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo((folder_ / "out").c_str(), 0600), 0);
  const pid_t writer = start("sh -c 'sleep 0.2; cat good.csv > in'");
  const pid_t reader = start("sh -c 'sleep 0.2; cat out > got.csv'");
  EXPECT_EQ(run("replay in --model model.toml --trajectory out --trajectory-step 0"), 0) << err_;
  EXPECT_EQ(status_of(writer), 0);
  EXPECT_EQ(status_of(reader), 0);
  EXPECT_EQ(run("replay good.csv --model model.toml --trajectory whole.csv --trajectory-step 0"),
            0);
  EXPECT_EQ(contents(folder_ / "got.csv"), contents(folder_ / "whole.csv"));
}

TEST_F(EveryVerb, AReaderThatGoesAwayLeavesNothingBehind) {
  std::string rows = "time_s,input_tension_N\n";
  for (int i = 0; i < 100'000; ++i) {
    rows += std::to_string(i) + ',' + std::to_string(i % 50) + '\n';
  }
  write("long.csv", rows);
  const auto before = snapshot();
  const std::string command = "cd '" + folder_.string() +
                              "' && { '" HOST_SIM
                              "' replay long.csv --model model.toml --report p.html "
                              "--trajectory - --trajectory-step 0 2> /dev/null; "
                              "test $? = 1 || touch other_status; } | head -c 10 > /dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0);
  EXPECT_TRUE(snapshot() == before);
}

TEST_F(EveryVerb, AHangUpLeavesNothingBehindUnlessItIsIgnored) {
  for (const bool ignored : {false, true}) {
    ASSERT_TRUE(ignored || ::mkfifo((folder_ / "in").c_str(), 0600) == 0);
    const pid_t process =
        start(std::string(ignored ? "nohup " : "") +
              "'" HOST_SIM "' replay in --model model.toml --json r.json > o.txt 2> e.txt");
    const pid_t writer = start("sh -c 'cat good.csv; sleep 1' > in");
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ::kill(process, SIGHUP);
    EXPECT_EQ(status_of(process), ignored ? 0 : 130);
    EXPECT_EQ(fs::exists(folder_ / "r.json"), ignored);
    status_of(writer);
    for (const std::string& name : files()) {
      EXPECT_EQ(name.find(".partial-"), std::string::npos) << name;
    }
  }
}

TEST_F(EveryVerb, AnOptionWithoutEffectIsAnError) {
  const std::string plan = "plan --for-diagnosis plan.toml ";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"replay good.csv --model model.toml --trajectory-step 1", "--trajectory"},
      {"replay - --model model.toml --threads 2", "--threads"},
      {"replay good.csv --model model.toml --node 2", "--can"},
      {plan + "--assurance 0.9", "--assurance"},
      {plan + "--simulations 200", "--simulations"},
      {plan + "--curvature 3", "--curvature"},
      {plan + "--specimens-max 30", "--specimens-max"},
      {"plan --model model.toml --levels 42.5,55 --use-tension 38 --specimens 3,3 "
       "--specimens-max 9",
       "--specimens-max"},
      {"monitor --log good.csv --once --listen 2", "--listen"},
      {"monitor --log good.csv --once --http-token x", "--http"}};
  for (const auto& [command, word] : cases) {
    expect_refused(command, 2, word);
  }
  expect_refused("replay good.csv --model model.toml --start-cycle 7", 1,
                 "model.toml: no [extension.friction_wear], and --start-cycle is for a sheath");
  for (const std::string without : {"current_offset,slack", "current_offset --without slack"}) {
    EXPECT_EQ(run("pack --out b.bin --without " + without + " model.toml"), 0);
    for (const std::string id : {"current_offset", "slack"}) {
      EXPECT_NE(err_.find(id + ": not in the model, nothing to leave out"), std::string::npos)
          << err_;
    }
  }
}

TEST_F(EveryVerb, AFlagFailsInWhicheverWayItIsReplayed) {
  write("overload.csv", "time_s,input_tension_N\n0,10\n0.005,190\n0.01,10\n");
  write("negative.csv", "time_s,input_tension_N\n0,10\n0.005,-20\n0.01,10\n");
  write("gap.csv", "time_s,input_tension_N\n0,10\n0.005,20\n1,10\n");
  const std::vector<std::pair<std::string, std::string>> flags{
      {"overload.csv", "overload"}, {"negative.csv", "negative_tension"}, {"gap.csv", "gap"}};
  for (const auto& [profile, flag] : flags) {
    for (const std::string& outputs : Names{"", " --json r.json", " --table -", " --can c.log"}) {
      const std::string command = "replay " + profile + " --model model.toml" + outputs;
      EXPECT_EQ(run(command + " --fail-on " + flag), 3) << command;
      EXPECT_EQ(run(command + " --fail-on saturated --fail-on " + flag), 3) << command;
      EXPECT_EQ(run(command + " --fail-on saturated,any"), 3) << command;
      EXPECT_EQ(run(command + " --fail-on saturated"), 0) << command;
    }
  }
}

TEST_F(EveryVerb, ADanglingLinkIsNoMissingFile) {
  fs::create_symlink("nowhere.csv", folder_ / "c/sessions.csv");
  EXPECT_EQ(run("diagnose c"), 1);
  EXPECT_NE(err_.find("c/sessions.csv: cannot be opened: No such file"), std::string::npos) << err_;
}

}  // namespace
