#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace host_sim_test {

/// Waits until an output is being written in `folder`.
inline void wait_for_partial(const std::filesystem::path& folder) {
  for (int i = 0; i < 1000; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().filename().string().find(".partial-") != std::string::npos) {
        return;
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  FAIL() << "host_sim did not start to work";
}

/// Starts host_sim in `folder`, asks it to stop when it is at work, and gives its status; its
/// standard error is in err.txt.
inline int status_of_interrupted(const std::filesystem::path& folder,
                                 std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), HOST_SIM);
  arguments.push_back(nullptr);
  const pid_t process = ::fork();
  if (process == 0) {
    const int error = ::open((folder / "err.txt").c_str(), O_WRONLY | O_CREAT, 0666);
    if (::chdir(folder.c_str()) == 0 && ::dup2(error, STDERR_FILENO) >= 0) {
      ::execv(HOST_SIM, const_cast<char* const*>(arguments.data()));
    }
    ::_exit(99);
  }
  wait_for_partial(folder);
  ::kill(process, SIGINT);
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace host_sim_test
