// SPDX-License-Identifier: Apache-2.0
#include "terminal/Guard.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "terminal/Terminal.h"

namespace terminal
{

namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHasOwnHandlers = true;
#else
constexpr bool kHasOwnHandlers = false;
#endif

constexpr const char* kRaise = "raise the limit (ulimit -v), or give it less to do";
constexpr const char* kFree = "end other programs, or give it less to do";

char theProgram[64] = "program";

/// The address space of this process, and the most that it may have; 0: no limit. Units: MiB.
struct AddressSpace
{
    unsigned long usedMiB = 0, mostMiB = 0;
};

/// Calls only what is allowed in a signal handler.
AddressSpace addressSpace()
{
    AddressSpace space;
    char text[64] = {};
    const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (file >= 0 && read(file, text, sizeof text - 1) > 0)
        space.usedMiB = std::strtoul(text, nullptr, 10) * static_cast<unsigned long>(getpagesize()) >> 20;
    if (file >= 0) close(file);
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        space.mostMiB = static_cast<unsigned long>(limit.rlim_cur >> 20);
    return space;
}

void describe(const AddressSpace& space, char* text, std::size_t size)
{
    if (space.mostMiB > 0)
        std::snprintf(text, size, "there is too little: %lu MiB of address space are in use, %lu allowed",
                      space.usedMiB, space.mostMiB);
    else
        std::snprintf(text, size, "there is too little: %lu MiB of address space are in use", space.usedMiB);
}

/// Writes the line of an error without any allocation, and ends the program.
[[noreturn]] void endWith(const char* place, const char* what, const char* remedy)
{
    char line[512];
    const int length = std::snprintf(line, sizeof line, "%s: %s: %s; %s\n", theProgram, place, what, remedy);
    const auto bytes =
        static_cast<std::size_t>(length) < sizeof line ? static_cast<std::size_t>(length) : sizeof line - 1;
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line, bytes);
    _exit(kFailed);
}

[[noreturn]] void endShortOfMemory(const AddressSpace& space)
{
    char what[128];
    describe(space, what, sizeof what);
    endWith("memory", what, space.mostMiB > 0 ? kRaise : kFree);
}

constexpr const char* kReport = "report it, with the command line and its files";

/// Called for exceptions that leave a thread.
[[noreturn]] void onTerminate()
{
    if (const std::exception_ptr thrown = std::current_exception()) try
        {
            std::rethrow_exception(thrown);
        }
        catch (const std::bad_alloc&)
        {
            endShortOfMemory(addressSpace());
        }
        catch (const std::exception& failure)
        {
            endWith("internal failure", failure.what(), kReport);
        }
        catch (...)
        {
        }
    std::abort();
}

/// Called for a crash. It counts as memory that could not be had when the limit is nearly used up.
void onCrash(int signal)
{
    const AddressSpace space = addressSpace();
    if (space.mostMiB > 0 && space.usedMiB + space.mostMiB / 4 + 64 >= space.mostMiB) endShortOfMemory(space);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

} // namespace

foundation::Error outOfMemory(const std::string& place)
{
    const AddressSpace space = addressSpace();
    char what[128];
    describe(space, what, sizeof what);
    if (place == "memory") return {place, what, space.mostMiB > 0 ? kRaise : kFree};
    return {place, std::string("does not fit into memory: ") + what, space.mostMiB > 0 ? kRaise : kFree};
}

int guarded(const std::string& program, const std::function<int()>& work)
{
    std::strncpy(theProgram, program.c_str(), sizeof theProgram - 1);
    std::set_terminate(onTerminate);
    if (!kHasOwnHandlers && addressSpace().mostMiB > 0)
        for (const int signal : {SIGSEGV, SIGBUS, SIGABRT})
            std::signal(signal, onCrash);
    try
    {
        return work();
    }
    catch (const std::bad_alloc&)
    {
        return fail(program, outOfMemory("memory"));
    }
    catch (const std::exception& failure)
    {
        return fail(program, {"internal failure", failure.what(), kReport});
    }
}

} // namespace terminal
