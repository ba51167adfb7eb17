// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace fieldbench
{

using Clock = std::chrono::steady_clock;

inline double milliseconds(Clock::time_point since)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}

} // namespace fieldbench
