// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a file of inputs: they are refused, or written and read back as the same numbers.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "simulation/control/InputTrack.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto track =
        simulation::parseInputs(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    if (!track) return 0;
    const std::string text = simulation::writeInputs(*track);
    const auto again = simulation::parseInputs(text, "again");
    if (!again || simulation::writeInputs(*again) != text) std::abort();
    std::vector<double> values(track->names.size());
    for (const double place : {0.0, track->rows.back().at / 2.0, track->rows.back().at + 1.0})
    {
        track->valuesAt(place, values);
        for (const double value : values)
            if (!std::isfinite(value)) std::abort();
    }
    return 0;
}
