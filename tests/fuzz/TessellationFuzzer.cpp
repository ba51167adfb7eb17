// SPDX-License-Identifier: Apache-2.0
// Any bytes may be a polygon: contours of corners, on a small grid or of any number that the bytes make. What
// comes out of it has to be triangles of its corners, none turned over.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <osgPMObjects/core/tessellate/ConvexDecomposition.h>
#include <osgPMObjects/core/tessellate/Orientation.h>
#include <osgPMObjects/core/tessellate/Tessellation.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace osgPMObjects::core;

constexpr std::size_t kMostCorners = 200;

/// First byte: how the others are read. A corner with the highest bit set begins a contour, on the grid.
struct Reader
{
    const std::uint8_t* data;
    std::size_t size;
    std::vector<glm::dvec3> corners;
    std::vector<std::uint32_t> contourSizes{0};

    void add(const glm::dvec3& corner, bool begins)
    {
        if (begins) contourSizes.push_back(0);
        ++contourSizes.back();
        corners.push_back(corner);
    }

    void readGrid()
    {
        for (std::size_t i = 0; i < size && corners.size() < kMostCorners; ++i)
            add({data[i] & 7, (data[i] >> 3) & 7, 0}, (data[i] & 128) != 0);
    }

    void readNumbers()
    {
        for (std::size_t i = 0; i + 25 <= size && corners.size() < kMostCorners; i += 25)
        {
            glm::dvec3 corner;
            std::memcpy(&corner, data + i, 24);
            add(corner, (data[i + 24] & 128) != 0);
        }
    }
};

bool isSound(const PolygonOutline& outline)
{
    for (const Loop& loop : outline.loops)
    {
        const auto triangles = clipEars(outline.points, loop);
        if (!triangles || triangles->size() + 2 > loop.size()) return false;
        for (const Triangle& t : *triangles)
            if (orientation(outline.points[t[0]], outline.points[t[1]], outline.points[t[2]]) <= 0.0)
                return false;
    }
    return true;
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) return 0;
    Reader reader{data + 1, size - 1, {}};
    if (data[0] & 1)
        reader.readNumbers();
    else
        reader.readGrid();
    const auto rule = static_cast<InsideRule>((data[0] >> 1) % 3);
    const auto projection = static_cast<ProjectionRule>((data[0] >> 3) % 3);
    const OutlineOptions options{projection, rule};
    if (const auto outline = outlinePolygon(reader.corners, reader.contourSizes, options))
    {
        if (!isSound(*outline)) std::abort();
        const auto method = data[0] & 128 ? ConvexMethod::leastPieces : ConvexMethod::quick;
        if (reader.corners.size() < 40 &&
            !decomposeConvex(reader.corners, reader.contourSizes, method, options))
            std::abort();
    }
    return 0;
}
