// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ctime>

namespace measurement
{

/// Returns the processor time that all threads of this process have used, in milliseconds; 0 where the system
/// does not tell.
inline double processorMs()
{
    timespec used{};
    if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used) != 0) return 0.0;
    return 1000.0 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

} // namespace measurement
