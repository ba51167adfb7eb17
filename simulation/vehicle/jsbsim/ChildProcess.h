// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <sys/types.h>

namespace simulation
{

/// A program that runs beside this one and writes to a pipe of its own. It never outlives this object, nor
/// the thread that started it: it is killed and waited for.
/// Threads: one. Only for Linux (the death of the parent is told by prctl).
class ChildProcess
{
public:
    /// The number of the pipe's end among the files of the child.
    static constexpr int kPipeInChild = 3;

    struct Command
    {
        std::filesystem::path program; ///< a path, or a name that PATH finds
        std::vector<std::string> arguments;
        std::filesystem::path outputFile; ///< takes what it prints
    };

    /// Errors: a program that cannot be started, files or processes used up.
    static foundation::Result<ChildProcess> start(const Command& command);

    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    ~ChildProcess();

    /// Whether it still runs; one that has ended is waited for.
    bool isRunning();

    /// How it ended, in words; empty while it runs.
    const std::string& ending() const { return _ending; }

    /// Reads what the child writes to its pipe.
    int pipe() const { return _pipe; }
    pid_t id() const { return _id; }

private:
    ChildProcess(pid_t id, int pipe) : _id(id), _pipe(pipe) {}
    void end();

    pid_t _id = -1; ///< -1: none, or waited for
    int _pipe = -1;
    std::string _ending;
};

} // namespace simulation
