// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/ChildProgram.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pmtool
{

namespace
{

using Clock = std::chrono::steady_clock;

/// The interval at which the program is polled; the program itself measures its time.
constexpr std::chrono::milliseconds kPause{2};

/// Starts a program. Returns its process, or a negative errno.
pid_t start(const std::vector<std::string>& command, const std::filesystem::path& outputFile)
{
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, outputFile.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes; // a group of its own, that what it starts ends with it
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    pid_t child = -1;
    const int failed =
        posix_spawnp(&child, arguments.front(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return failed == 0 ? child : -failed;
}

/// Waits for a program. Returns false when the time is over.
bool waitFor(pid_t child, double seconds, int& status)
{
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (true)
    {
        const pid_t done = waitpid(child, &status, WNOHANG);
        if (done == child || (done < 0 && errno != EINTR)) return true;
        if (Clock::now() > end) break;
        std::this_thread::sleep_for(kPause);
    }
    kill(-child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    return false;
}

} // namespace

foundation::Outcome runProgram(const std::vector<std::string>& command,
                               const std::filesystem::path& outputFile, double seconds)
{
    const pid_t child = start(command, outputFile);
    if (child < 0)
        return foundation::Error{command.front(), std::string("cannot be started: ") + std::strerror(-child),
                                 "name a program"};
    int status = 0;
    std::ostringstream what;
    if (!waitFor(child, seconds, status))
        what << "was not done after " << seconds << " s";
    else if (WIFSIGNALED(status))
        what << "died of " << strsignal(WTERMSIG(status));
    else if (WEXITSTATUS(status) != 0)
        what << "ended with code " << WEXITSTATUS(status);
    else
        return foundation::success();
    return foundation::Error{command.front(), what.str(), "see what it says, or give it more time"};
}

} // namespace pmtool
