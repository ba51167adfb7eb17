// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a progressive mesh: they become a valid one, whose levels can be played, or are
// refused. Check sums are made anew, or nothing would get beyond them.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include <osgPMObjects/core/progressive/CompactedLevel.h>
#include <osgPMObjects/core/progressive/PmFile.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

#include "PmCheckSums.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace osgPMObjects::core;
    std::string bytes(reinterpret_cast<const char*>(data), size);
    testsupport::renewCheckSums(bytes);
    std::istringstream stream(bytes);
    PmReader reader(stream, "fuzz.pm");
    while (true)
    {
        const auto more = reader.readMore();
        if (!more) return more.error().place.starts_with("fuzz.pm") ? 0 : (std::abort(), 0);
        const auto mesh = reader.mesh();
        if (mesh)
        {
            if (!isValid(*mesh)) std::abort();
            ProgressiveLevel level(*mesh);
            level.moveTo(mesh->stepCount / 2);
            CompactedLevel compacted(*mesh);
            compacted.moveTo(mesh->stepCount / 2);
        }
        if (!*more) return 0;
    }
}
