// SPDX-License-Identifier: Apache-2.0
#include "ContainedRun.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <sstream>

#include <fcntl.h>
#include <foundation/HugeHeap.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace osgPMObjects
{

namespace
{

/// The first byte of what the child sends; it tells what follows.
constexpr char kBytes = 'B', kError = 'E', kNoMemory = 'M';
constexpr const char* kRepair = "repair the model, or convert it with another program";

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

void writeAll(int descriptor, const char* bytes, std::size_t count)
{
    while (count > 0)
    {
        const ssize_t written = ::write(descriptor, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return; // the reader is gone
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
}

void say(int descriptor, char kind, const std::string& text)
{
    writeAll(descriptor, &kind, 1);
    writeAll(descriptor, text.data(), text.size());
}

/// Names the limit that was in the way: the caller's, or that of this process where it is lower.
foundation::Error noMemory(const std::string& file, const std::string& what, const ReadLimits& limits)
{
    rlimit own{};
    const bool isOwn = getrlimit(RLIMIT_AS, &own) == 0 && own.rlim_cur != RLIM_INFINITY &&
                       own.rlim_cur >> 20 < limits.memoryMiB;
    return {file,
            what + " wanted more than " + std::to_string(isOwn ? own.rlim_cur >> 20 : limits.memoryMiB) +
                (isOwn ? " MiB of address space" : " MiB"),
            std::string(isOwn ? "raise the limit (ulimit -v), or " : "allow it more memory, or ") + kRepair};
}

void restrain(const ReadLimits& limits)
{
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    foundation::shrinkHeap();
    const rlim_t bytes = static_cast<rlim_t>(limits.memoryMiB) << 20;
    const rlimit memory{bytes, bytes};
    if (!kIsSanitized) setrlimit(RLIMIT_AS, &memory);
    for (const int signal :
         {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) // default handlers instead of inherited ones
        std::signal(signal, SIG_DFL);
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        dup2(nowhere, descriptor);
}

[[noreturn]] void beChild(int descriptor, const std::function<foundation::Result<std::string>()>& work,
                          const ReadLimits& limits)
{
    restrain(limits);
    try
    {
        const auto made = work();
        if (made)
            say(descriptor, kBytes, *made);
        else
            say(descriptor, kError, made.error().what + '\n' + made.error().remedy);
    }
    catch (const std::bad_alloc&)
    {
        say(descriptor, kNoMemory, "");
    }
    catch (const std::exception& thrown)
    {
        say(descriptor, kError, std::string(thrown.what()) + '\n' + kRepair);
    }
    _exit(0); // no destructors: they would run in the parent, too
}

/// Reads until the child has ended; returns false if it takes too long.
bool readAll(int descriptor, double seconds, std::string& bytes)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    std::string buffer(1 << 16, '\0');
    while (true)
    {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now())
                .count();
        if (left <= 0) return false;
        pollfd waiting{descriptor, POLLIN, 0};
        const int ready = poll(&waiting, 1, static_cast<int>(std::min<long long>(left, 1000)));
        if (ready <= 0) continue;
        const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return true;
        bytes.append(buffer, 0, static_cast<std::size_t>(got));
    }
}

foundation::Error asError(const std::string& file, const std::string& text)
{
    const std::size_t line = text.find('\n');
    return {file, text.substr(0, line), line == std::string::npos ? "" : text.substr(line + 1)};
}

} // namespace

foundation::Result<std::string> runContained(const std::function<foundation::Result<std::string>()>& work,
                                             const std::string& file, const std::string& what,
                                             const ReadLimits& limits)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return foundation::Error{file, std::string("no pipe to read it through: ") + std::strerror(errno),
                                 "close files"};
    const pid_t child = fork();
    if (child < 0)
    {
        close(ends[0]), close(ends[1]);
        return foundation::Error{file, std::string("no process to read it in: ") + std::strerror(errno),
                                 "end others"};
    }
    if (child == 0) beChild(ends[1], work, limits);
    close(ends[1]);
    std::string bytes;
    const bool isInTime = readAll(ends[0], limits.seconds, bytes);
    close(ends[0]);
    if (!isInTime) kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    std::ostringstream seconds;
    seconds << limits.seconds;
    if (!isInTime)
        return foundation::Error{file, what + " was not done after " + seconds.str() + " s",
                                 std::string("give it more time, or ") + kRepair};
    if (WIFSIGNALED(status))
        return foundation::Error{file, what + " died of " + strsignal(WTERMSIG(status)), kRepair};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty())
        return foundation::Error{file, what + " ended itself", kRepair};
    const char kind = bytes.front();
    bytes.erase(0, 1);
    if (kind == kNoMemory) return noMemory(file, what, limits);
    if (kind == kError) return asError(file, bytes);
    return bytes;
}

} // namespace osgPMObjects
