// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/ShellRun.h"

#include <cerrno>
#include <cstring>

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace terraintool
{

namespace
{

double secondsOf(const timeval& time)
{
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

} // namespace

foundation::Result<ShellRun> runInShell(const std::string& command, const std::vector<std::string>& arguments)
{
    std::vector<std::string> words{"/bin/sh", "-c", command + " \"$@\"", "sh"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    pid_t child = 0;
    const int failed = posix_spawn(&child, pointers.front(), &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0)
        return foundation::Error{command, std::string("cannot be begun: ") + std::strerror(failed),
                                 "check that there is a shell"};
    int status = 0;
    rusage used{};
    while (wait4(child, &status, 0, &used) < 0 && errno == EINTR)
    {
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return foundation::Error{command,
                                 WIFEXITED(status) ? "ended with code " + std::to_string(WEXITSTATUS(status))
                                                   : "was ended by a signal",
                                 "see what it says above"};
    return ShellRun{secondsOf(used.ru_utime) + secondsOf(used.ru_stime)};
}

} // namespace terraintool
