// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// Whether a fuzzer does what takes far longer than reading on an input of this size: on one size of so many
/// under libFuzzer, so that the reader itself is tried more often, and on each in the tests that replay
/// inputs.
constexpr bool isDearPartDone([[maybe_unused]] std::size_t size, [[maybe_unused]] std::size_t oneOf)
{
#ifdef OSGTRAINER_LIBFUZZER
    return size % oneOf == 0;
#else
    return true;
#endif
}
