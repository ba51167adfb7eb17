// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Which vertices of an octree's cell are support vertices.
enum class SupportRule
{
    none,
    farthest,           ///< from the cell's centre
    farthestAndNearest, ///< from the cell's centre
};

/// The leaf cells of an octree over a box: their number along each axis, each a power of two.
struct OctreeDivisions
{
    std::array<std::uint32_t, 3> counts{1, 1, 1};

    /// Divides the box `depth` times, at most 10; each time every cell is halved along every axis.
    static OctreeDivisions ofDepth(std::uint32_t depth);

    /// Whether the counts are powers of two, at most 1024.
    bool isValid() const;
};

/// The cell of a point in or on the box, and the centre of a cell. Cells are half open except the last along
/// an axis, so each point belongs to one cell.
std::array<std::uint32_t, 3> cellOf(const glm::dvec3& point, const Extent& box,
                                    const OctreeDivisions& divisions);
glm::dvec3 centreOf(const std::array<std::uint32_t, 3>& cell, const Extent& box,
                    const OctreeDivisions& divisions);

/// Returns by position whether it is a support vertex: the farthest from, or nearest to, the centre of its
/// cell. The octree covers the box of all positions that faces use. Of equal distances all are support
/// vertices, so the result does not depend on their order.
/// `divisions`: valid. Cost: n log n. Units: as the positions.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 4.
/// Differs: the formula for centres there, (x_min + x_max) / 2k, is a misprint that gives all cells of an
/// axis one centre; and a point on the border of two cells belongs to both, here to the upper one.
std::vector<bool> supportVertices(const Mesh& mesh, const OctreeDivisions& divisions, SupportRule rule);

} // namespace osgPMObjects::core
