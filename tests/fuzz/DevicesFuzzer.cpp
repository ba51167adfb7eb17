// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a devices file: they are refused, or every place of every axis is an input within
// its range.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "input/DeviceFile.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto maps =
        trainer::parseDevices(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    if (!maps) return 0;
    for (const trainer::DeviceMap& map : *maps)
        for (const trainer::DeviceAxis& axis : map.axes)
            for (const double place : {-2.0, -1.0, -0.3, 0.0, 0.7, 1.0, std::nan("")})
                for (const double least : {-1.0, 0.0})
                {
                    const double value = trainer::inputOf(axis, place, least, 1.0);
                    if (!(value >= least && value <= 1.0)) std::abort();
                }
    trainer::mapFor(*maps, "some wheel");
    return 0;
}
