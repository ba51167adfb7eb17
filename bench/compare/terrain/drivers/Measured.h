// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <viewlod/Slice.h>

namespace terraintool
{

/// Measures some work in microseconds of this thread, so that other work on the machine does not count.
template<class Work>
double microsecondsOf(const Work& work)
{
    const double begin = viewlod::Slice::threadUs();
    work();
    return viewlod::Slice::threadUs() - begin;
}

} // namespace terraintool
