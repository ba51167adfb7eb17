// SPDX-License-Identifier: Apache-2.0
#include "LimitedRun.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

/// A program is killed after so many times the limit: on a busy machine the processor time tells more.
constexpr double kPatience = 4.0;

/// What the process between the caller and the program reports.
struct Report
{
    int status = 0;
    bool isOutOfTime = false;
    double seconds = 0.0;
    long memoryKiB = 0;
};

[[noreturn]] void become(const std::vector<std::string>& command, int errors, const RunLimits& limits)
{
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(
            const_cast<char*>(argument.c_str())); // execvp's old signature; it changes nothing
    arguments.push_back(nullptr);
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    // Address space is not memory: a program that reserves much and uses little passes.
    const auto bytes = static_cast<rlim_t>(4.0 * limits.memoryMiB) << 20;
    const rlimit data{bytes, bytes};
    setrlimit(RLIMIT_DATA, &data);
    setpgid(0, 0);
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(errors, STDERR_FILENO);
    execvp(arguments.front(), arguments.data());
    _exit(127);
}

/// Runs the command in a child of this process, which has no other, so that the resources of its children are
/// those of the command.
Report supervise(const std::vector<std::string>& command, int errors, const RunLimits& limits)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const pid_t child = fork();
    if (child == 0) become(command, errors, limits);
    Report report;
    while (waitpid(child, &report.status, WNOHANG) == 0)
    {
        if (!report.isOutOfTime && elapsed() > kPatience * limits.seconds)
        {
            report.isOutOfTime = true;
            kill(-child, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
    }
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    const auto secondsOf = [](const timeval& time)
    { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
    report.seconds = secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
    report.memoryKiB = used.ru_maxrss;
    return report;
}

} // namespace

std::string LimitedRun::fault(const RunLimits& limits) const
{
    char text[128] = {};
    if (isOutOfTime || seconds > limits.seconds)
        std::snprintf(text, sizeof text, "not done after %.0f s", limits.seconds);
    else if (exitCode > 128)
        std::snprintf(text, sizeof text, "died of signal %d (%s)", exitCode - 128, strsignal(exitCode - 128));
    else if (memoryMiB > limits.memoryMiB)
        std::snprintf(text, sizeof text, "took %.0f MiB of memory", memoryMiB);
    else if (exitCode != 0 && exitCode != 1 && exitCode != 2)
        std::snprintf(text, sizeof text, "exit code %d", exitCode);
    else if (exitCode != 0 && errors.find(": ") == std::string::npos)
        std::snprintf(text, sizeof text, "failed without a word");
    return text;
}

LimitedRun runLimited(const std::vector<std::string>& command, const RunLimits& limits)
{
    LimitedRun run;
    int ends[2];
    const int errors = memfd_create("errors", MFD_CLOEXEC);
    if (errors < 0 || pipe2(ends, O_CLOEXEC) != 0) return run;
    const pid_t supervisor = fork();
    if (supervisor == 0)
    {
        const Report report = supervise(command, errors, limits);
        [[maybe_unused]] const ssize_t sent = write(ends[1], &report, sizeof report);
        _exit(0);
    }
    close(ends[1]);
    Report report;
    while (waitpid(supervisor, nullptr, 0) < 0 && errno == EINTR)
        ;
    if (read(ends[0], &report, sizeof report) == sizeof report)
    {
        run.exitCode = WIFEXITED(report.status) ? WEXITSTATUS(report.status) : 128 + WTERMSIG(report.status);
        run.isOutOfTime = report.isOutOfTime;
        run.seconds = report.seconds;
        run.memoryMiB = static_cast<double>(report.memoryKiB) / 1024.0;
    }
    close(ends[0]);
    std::array<char, 4096> words{};
    if (const ssize_t got = pread(errors, words.data(), words.size(), 0); got > 0)
        run.errors.assign(words.data(), static_cast<std::size_t>(got));
    close(errors);
    return run;
}
