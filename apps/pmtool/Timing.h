// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include <viewlod/Slice.h>

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

/// The same as far as this thread computes.
template<class Work>
double threadMillisecondsOf(const Work& work)
{
    const double beganUs = viewlod::Slice::threadUs();
    work();
    return (viewlod::Slice::threadUs() - beganUs) / 1000.0;
}

} // namespace pmtool
