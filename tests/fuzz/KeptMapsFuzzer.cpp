// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as what a map held: features and shapes come back as they were written, or nothing
// does.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "FeatureBytes.h"
#include "ShapeBytes.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace osgTerrainROAM::core;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (const auto features = featuresIn(bytes))
    {
        const auto written = bytesOf(*features);
        const auto again = featuresIn(written);
        if (!again || bytesOf(*again) != written) std::abort();
    }
    if (const auto shapes = shapesIn(bytes))
    {
        const auto written = bytesOf(*shapes);
        const auto again = shapesIn(written);
        if (!again || bytesOf(*again) != written) std::abort();
    }
    return 0;
}
