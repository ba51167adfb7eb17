// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a .roam file, as a .bisection file or as a table of classes: they are read, or
// refused with their place.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/bisection/BisectionFile.h>
#include <osgTerrainROAM/core/cover/CoverTable.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace osgTerrainROAM::core;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto file = parseRoamFile(text, "fuzz.roam");
    if (file ? file->dems.empty() || file->imagery.size() > RoamFile::kMaxImagery
             : !file.error().place.starts_with("fuzz.roam:"))
        std::abort();
    const auto surface = parseBisectionFile(text, "fuzz.bisection");
    if (surface
            ? surface->levels < 0 || surface->levels > 24 || (!surface->mesh.empty() && !surface->dem.empty())
            : !surface.error().place.starts_with("fuzz.bisection"))
        std::abort();
    const auto table = parseCoverTable(text, "fuzz.txt");
    if (table ? table->empty() : !table.error().place.starts_with("fuzz.txt")) std::abort();
    return 0;
}
