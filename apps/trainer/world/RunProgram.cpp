// SPDX-License-Identifier: Apache-2.0
#include "RunProgram.h"

#include <cerrno>
#include <cstring>
#include <iostream>

#include <fcntl.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trainer
{

namespace
{

/// A lock between processes, as long as it lives.
class FileLock
{
public:
    explicit FileLock(const std::filesystem::path& file)
        : _file(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666))
    {
        if (_file < 0 || flock(_file, LOCK_EX | LOCK_NB) == 0) return;
        std::cerr << "trainer: waits for another program that holds " << file.string() << '\n';
        while (flock(_file, LOCK_EX) != 0 && errno == EINTR)
        {
        }
    }
    ~FileLock()
    {
        if (_file >= 0) close(_file);
    }
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    bool isHeld() const { return _file >= 0; }

private:
    int _file;
};

} // namespace

foundation::Result<int> runProgram(const std::vector<std::string>& words, const std::filesystem::path& lock)
{
    const FileLock held(lock);
    if (!held.isHeld())
        return foundation::Error{lock.string(), std::string("cannot be written: ") + std::strerror(errno),
                                 "check the folder's permissions"};
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(
            const_cast<char*>(word.c_str())); // posix_spawn's old signature; it changes nothing
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int failed = posix_spawn(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0)
        return foundation::Error{words.front(), std::string("cannot be begun: ") + std::strerror(failed),
                                 "check that it is a program"};
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace trainer
