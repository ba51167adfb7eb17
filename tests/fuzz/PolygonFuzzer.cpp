// SPDX-License-Identifier: Apache-2.0
// Any bytes may be a file of polygons: .obj or GeoJSON. A set that is read must be as PolygonSet promises.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <string_view>
#include <vector>

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

/// Whether the faces show few texels: the time of a warped texture follows their number.
bool areSmall(const std::vector<pmtool::TexturedFace>& faces)
{
    for (const pmtool::TexturedFace& face : faces)
        for (const glm::dvec2& t : face.quad.texCoords)
            if (!(std::abs(t.x) < 10.0 && std::abs(t.y) < 10.0)) return false;
    return true;
}

void check(const foundation::Result<pmtool::PolygonSet>& set)
{
    if (!set) return;
    if (!isSound(*set)) std::abort();
    if (set->positions.size() > 200) return; // crossings cost the square of the corners
    for (const auto texture :
         {pmtool::QuadTexture::affine, pmtool::QuadTexture::preWarped, pmtool::QuadTexture::projective})
    {
        const double tolerance = texture == pmtool::QuadTexture::affine ? 0.05 : 0.0;
        const pmtool::CutSettings settings{.warpTolerance = tolerance, .quadTexture = texture};
        const auto cut = pmtool::cutPolygons(*set, settings, "fuzz");
        if (!cut) continue;
        pmtool::objTextOf(*cut);
        if (!areSmall(cut->texturedFaces)) continue;
        const pmtool::Texels texture8{8, 8, std::vector<glm::vec4>(64)};
        if (const auto warped = pmtool::warpTexture(texture8, cut->texturedFaces);
            warped && warped->colours.size() != 64)
            std::abort();
    }
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
