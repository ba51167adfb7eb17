// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Which vertices of an octree's cell stay.
enum class SupportRule
{
    none,
    farthest,           ///< from the cell's centre
    farthestAndNearest, ///< from the cell's centre
};

/// The leaves of an octree over a box: so many along each axis, all powers of two.
struct OctreeDivisions
{
    std::array<std::uint32_t, 3> counts{1, 1, 1};

    /// By halving every cell along every axis, `depth` times; at most 10.
    static OctreeDivisions ofDepth(std::uint32_t depth);

    /// Whether an octree has them: powers of two, at most 1024.
    bool isValid() const;
};

/// The cell of a point in or on the box, and the centre of a cell. Cells are half open, but for the last along an axis: a
/// point belongs to one cell.
std::array<std::uint32_t, 3> cellOf(const glm::dvec3& point, const Extent& box,
                                    const OctreeDivisions& divisions);
glm::dvec3 centreOf(const std::array<std::uint32_t, 3>& cell, const Extent& box,
                    const OctreeDivisions& divisions);

/// By position, whether it is a support vertex: in its cell of the octree over the box of all positions that faces use, the farthest
/// from the centre, or the nearest. Equally far ones are all of them: the corners of a cube are not told apart by their order.
/// `divisions`: valid. Cost: n log n. Units: as the positions.
/// Source: paper 004, §4. Its formula for the centres (x_min + x_max) / 2k is a misprint, which puts all cells of an axis at one
/// place; these are the true ones. By its inequalities a point on the border of two cells is in both; here it is in the upper.
std::vector<bool> supportVertices(const Mesh& mesh, const OctreeDivisions& divisions, SupportRule rule);

} // namespace osgPMObjects::core
