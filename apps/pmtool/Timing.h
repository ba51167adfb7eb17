// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace pmtool
{

/// How long some work takes, elapsed.
template<class Work>
double millisecondsOf(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace pmtool
