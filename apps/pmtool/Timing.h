// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include <viewlod/Slice.h>

namespace pmtool
{

/// Returns how long some work takes, in milliseconds of elapsed time.
template<class Work>
double millisecondsOf(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Returns how long this thread computes for some work, in milliseconds of processor time.
template<class Work>
double threadMillisecondsOf(const Work& work)
{
    const double beganUs = viewlod::Slice::threadUs();
    work();
    return (viewlod::Slice::threadUs() - beganUs) / 1000.0;
}

} // namespace pmtool
