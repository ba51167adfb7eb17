// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include <foundation/Threads.h>

namespace foundation
{

/// Calls `work(i)` for each number below `count`, in as many threads as there are processors, the next free
/// one taking the next number, and waits for all. What is written to a place of its own for each number does
/// not depend on the threads' timing.
/// Errors: the first exception of the work is thrown again here, after all have ended.
template<class Work>
void forEachAtOnce(std::size_t count, const Work& work)
{
    std::atomic<std::size_t> next{0};
    const auto run = [&]
    {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    Threads others;
    for (std::size_t t = 1; t < std::min<std::size_t>(count, processors()); ++t)
        others.run(run);
    run();
    others.join();
}

} // namespace foundation
