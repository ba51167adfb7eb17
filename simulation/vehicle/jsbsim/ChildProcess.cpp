// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/ChildProcess.h"

#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace simulation
{
namespace
{

std::string reasonOf(int error)
{
    return std::generic_category().message(error);
}

/// In the child, between fork and exec: only what is safe there. Tells why it cannot go on by a number in
/// `report`.
[[noreturn]] void becomeProgram(char* const* arguments, const char* outputFile, int pipeEnd, int report,
                                pid_t parent)
{
    const auto give = [&](int error)
    {
        [[maybe_unused]] const ssize_t written = write(report, &error, sizeof error);
        _exit(127);
    };
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) give(errno);
    if (getppid() != parent) _exit(127); // it died before it could be told
    const int nothing = open("/dev/null", O_RDONLY);
    const int output = open(outputFile, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (nothing < 0 || output < 0) give(errno);
    // Both go out of the way of the numbers that the program gets.
    const int kept = fcntl(report, F_DUPFD_CLOEXEC, 10);
    const int end = fcntl(pipeEnd, F_DUPFD_CLOEXEC, 10);
    if (kept < 0 || end < 0) give(errno);
    report = kept;
    if (dup2(nothing, 0) < 0 || dup2(output, 1) < 0 || dup2(output, 2) < 0 ||
        dup2(end, ChildProcess::kPipeInChild) < 0)
        give(errno);
    // Whatever else is open here closes when the program begins; a kernel that cannot do so leaves it the
    // files that ask for no such thing.
    close_range(ChildProcess::kPipeInChild + 1, ~0U, CLOSE_RANGE_CLOEXEC);
    execvp(arguments[0], arguments);
    give(errno);
    _exit(127);
}

std::string endingOf(int status)
{
    if (WIFSIGNALED(status)) return "was ended by signal " + std::to_string(WTERMSIG(status));
    return "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

/// Reads the number of the error that kept the child from becoming the program; 0: it became it.
int readReport(int report)
{
    int error = 0;
    ssize_t got = 0;
    do
        got = read(report, &error, sizeof error);
    while (got < 0 && errno == EINTR);
    return got == static_cast<ssize_t>(sizeof error) ? error : 0;
}

} // namespace

foundation::Result<ChildProcess> ChildProcess::start(const Command& command)
{
    const auto refuse = [&](int error)
    {
        return foundation::Error{command.program.string(), "cannot be started: " + reasonOf(error),
                                 error == ENOENT ? "install it, or name where it is"
                                                 : "check its permissions"};
    };
    int data[2], report[2];
    if (pipe2(data, O_CLOEXEC) != 0) return refuse(errno);
    if (pipe2(report, O_CLOEXEC) != 0)
    {
        const int error = errno;
        close(data[0]);
        close(data[1]);
        return refuse(error);
    }
    std::vector<std::string> texts{command.program.string()};
    texts.insert(texts.end(), command.arguments.begin(), command.arguments.end());
    std::vector<char*> arguments;
    for (std::string& text : texts)
        arguments.push_back(text.data());
    arguments.push_back(nullptr);
    const std::string outputFile = command.outputFile.string();
    const pid_t parent = getpid(), id = fork();
    if (id == 0) becomeProgram(arguments.data(), outputFile.c_str(), data[1], report[1], parent);
    const int forkError = errno;
    close(data[1]);
    close(report[1]);
    const int error = id < 0 ? forkError : readReport(report[0]);
    close(report[0]);
    ChildProcess child(id, data[0]);
    if (error != 0) return refuse(error);
    return child;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : _id(std::exchange(other._id, -1)),
      _pipe(std::exchange(other._pipe, -1)),
      _ending(std::move(other._ending))
{
}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept
{
    if (this == &other) return *this;
    end();
    _id = std::exchange(other._id, -1);
    _pipe = std::exchange(other._pipe, -1);
    _ending = std::move(other._ending);
    return *this;
}

ChildProcess::~ChildProcess()
{
    end();
}

void ChildProcess::end()
{
    if (_pipe >= 0) close(_pipe);
    _pipe = -1;
    if (_id <= 0) return;
    kill(_id, SIGKILL);
    while (waitpid(_id, nullptr, 0) < 0 && errno == EINTR)
    {
    }
    _id = -1;
}

bool ChildProcess::isRunning()
{
    if (_id <= 0) return false;
    int status = 0;
    if (waitpid(_id, &status, WNOHANG) != _id) return true;
    _id = -1;
    _ending = endingOf(status);
    return false;
}

} // namespace simulation
