// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a key script: they are refused, or events in the order of time.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "input/KeyScript.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto events =
        trainer::parseKeyScript(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    if (!events) return 0;
    double lastS = 0.0;
    for (const trainer::WindowEvent& event : *events)
    {
        if (!std::isfinite(event.atS) || event.atS < lastS) std::abort();
        lastS = event.atS;
    }
    return 0;
}
