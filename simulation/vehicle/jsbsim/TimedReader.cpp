// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/TimedReader.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>

#include <poll.h>
#include <unistd.h>

namespace simulation
{
namespace
{

constexpr std::size_t kMostBytes = 1u << 20;

using Clock = std::chrono::steady_clock;

/// Waits until there is something to read, an end among it.
bool waitsFor(int file, Clock::time_point until)
{
    for (;;)
    {
        const double leftMs = std::chrono::duration<double, std::milli>(until - Clock::now()).count();
        pollfd entry{file, POLLIN, 0};
        const int ready = poll(&entry, 1, leftMs > 0.0 ? static_cast<int>(std::ceil(leftMs)) : 0);
        if (ready > 0) return true;
        if (ready == 0 && leftMs <= 0.0) return false;
        if (ready < 0 && errno != EINTR) return true; // the reading tells what is wrong
    }
}

} // namespace

ReadEnd TimedReader::until(std::string_view mark, double withinS, std::string& text)
{
    const auto end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(withinS));
    text.clear();
    std::size_t searched = 0;
    for (;;)
    {
        const std::size_t at = _pending.find(mark, searched);
        if (at != std::string::npos)
        {
            text = _pending.substr(0, at);
            _pending.erase(0, at + mark.size());
            return ReadEnd::complete;
        }
        searched = _pending.size() - std::min(_pending.size(), mark.size() - 1);
        if (_pending.size() > kMostBytes) return ReadEnd::tooLong;
        if (!waitsFor(_file, end)) return ReadEnd::late;
        std::array<char, 4096> bytes;
        const ssize_t got = read(_file, bytes.data(), bytes.size());
        if (got == 0) return ReadEnd::closed;
        if (got < 0 && errno != EINTR && errno != EAGAIN) return ReadEnd::closed;
        if (got > 0) _pending.append(bytes.data(), static_cast<std::size_t>(got));
    }
}

void TimedReader::discard()
{
    _pending.clear();
    std::array<char, 4096> bytes;
    while (waitsFor(_file, Clock::now()))
        if (const ssize_t got = read(_file, bytes.data(), bytes.size()); got <= 0 && errno != EINTR) return;
}

} // namespace simulation
