// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// The corners around the star of a vertex, counter-clockwise. Triangle i of the star has corners i and i + 1
/// and the vertex; the last of a closed ring joins the last corner with the first.
struct StarRing
{
    static constexpr std::size_t kMost = 16;

    std::array<std::uint32_t, kMost> corners{};
    std::size_t count = 0;
    bool isClosed = true; ///< false: the vertex lies on the side from the last corner to the first

    std::size_t triangles() const { return isClosed ? count : count - 1; }
    Triangle triangle(std::size_t i, std::uint32_t vertex) const
    {
        return {corners[i], corners[i + 1 < count ? i + 1 : 0], vertex};
    }
};

/// Finds the ring around the area of a floor as its star has it. A closed ring begins at its lowest number.
/// So a star follows from its floor and its vertex. Returns whether the floor is one area whose border has no
/// corner twice, and the star's triangles are all counter-clockwise.
/// `floor`: corners as numbers in `points`, all there. `vertex`: where the vertex lies.
bool findStarRing(std::span<const Triangle> floor, std::span<const SurfacePoint> points,
                  const SurfacePoint& vertex, StarRing& ring);

} // namespace osgMultiTriangulation::core
