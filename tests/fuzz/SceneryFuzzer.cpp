// SPDX-License-Identifier: Apache-2.0
// Any text may be given as a scenery: it becomes a description that keeps to its ranges, or is refused with
// place and remedy.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "scenery/placement/ReadScenery.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace scenery;
    const auto read = parseScenery({reinterpret_cast<const char*>(data), size}, "fuzz.json");
    if (!read)
    {
        if (!read.error().place.starts_with("fuzz.json") || read.error().remedy.empty()) std::abort();
        return 0;
    }
    for (const SceneryField& field : read->fields)
    {
        if (field.objects.empty() || field.name.empty() || !(field.leastScale > 0.0)) std::abort();
        if (!(field.selection.settings.band >= 1.0) || !(field.crowding < 1.0)) std::abort();
    }
    return 0;
}
