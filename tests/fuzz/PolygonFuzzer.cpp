// SPDX-License-Identifier: Apache-2.0
// Any bytes may be a file of polygons: .obj or GeoJSON. A set that is read must be as PolygonSet promises.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <string_view>

#include "pmtool/polygons/CutPolygons.h"
#include "pmtool/polygons/ReadPolygons.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

bool isSound(const pmtool::PolygonSet& set)
{
    for (const glm::dvec3& p : set.positions)
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
    if (!set.texCoords.empty() && set.texCoords.size() != set.positions.size()) return false;
    for (const pmtool::Polygon& polygon : set.polygons)
    {
        for (const std::uint32_t corner : polygon.corners)
            if (corner >= set.positions.size()) return false;
        for (const std::uint32_t count : polygon.contourSizes)
            if (count < 3) return false;
        const auto& sizes = polygon.contourSizes;
        if (std::accumulate(sizes.begin(), sizes.end(), std::size_t(0)) != polygon.corners.size())
            return false;
    }
    return true;
}

void check(const foundation::Result<pmtool::PolygonSet>& set)
{
    if (!set) return;
    if (!isSound(*set)) std::abort();
    if (set->positions.size() > 200) return; // crossings cost the square of the corners
    if (const auto cut = pmtool::cutPolygons(*set, {.warpTolerance = 0.05}, "fuzz")) pmtool::objTextOf(*cut);
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    check(pmtool::parseObj(text, "fuzz"));
    check(pmtool::parseGeoJson(text, "fuzz"));
    return 0;
}
