// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include <foundation/Threads.h>

namespace osgPMObjects::core
{

/// Divides the numbers 0 … count-1 into consecutive shares, calls `work(first, last, share)` for each in a
/// thread of its own, and waits for all. Results that are joined in the order of the shares do not depend on
/// the threads' timing. A share has at least `least` numbers, so small work stays in the calling thread.
/// Returns the number of shares.
/// Errors: the first exception of a share is thrown again here, after all have ended.
template<class Work>
std::size_t parallelShares(std::size_t count, std::size_t least, const Work& work)
{
    const std::size_t threads = foundation::processors();
    const std::size_t shares = std::clamp<std::size_t>(count / std::max<std::size_t>(least, 1), 1, threads);
    foundation::Threads others;
    for (std::size_t s = 1; s < shares; ++s)
        others.run([&work, count, shares, s] { work(count * s / shares, count * (s + 1) / shares, s); });
    work(std::size_t{0}, count / shares, std::size_t{0});
    others.join();
    return shares;
}

} // namespace osgPMObjects::core
