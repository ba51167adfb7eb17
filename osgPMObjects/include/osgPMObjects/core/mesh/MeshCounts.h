// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Tolerances of defects as shares of the diagonal, as in the published figures of the test models.
constexpr double kTJunctionTolerance = 1e-5;
constexpr double kDegenerateHeight = 1e-9;

/// Counts of a mesh's elements and defects. Positions are distinguished by their number.
struct MeshCounts
{
    std::size_t triangles = 0;
    std::size_t positions = 0;         ///< used by faces
    std::size_t attributeVertices = 0; ///< distinct (position, attributes, material) used by faces
    std::size_t tJunctions = 0;        ///< vertices in a T-junction, see findTJunctions()
    std::size_t duplicates =
        0; ///< faces with the same three positions as an earlier one, in either orientation
    std::size_t degenerates = 0;      ///< faces that use a position twice, or lower than kDegenerateHeight
    std::size_t nonManifoldEdges = 0; ///< edges with more than two faces
    std::size_t boundaryEdges = 0;    ///< edges with one
    std::size_t components = 0;       ///< groups of faces that share positions

    bool operator==(const MeshCounts&) const = default;
};

/// Counts elements and defects. Cost: about linear; a million triangles in 2 s.
MeshCounts countMesh(const Mesh& mesh);

/// The box around all positions that faces use.
Extent extentOfFaces(const Mesh& mesh);

/// The diagonal of that box. Units: as the positions.
inline double diagonalOf(const Mesh& mesh)
{
    return extentOfFaces(mesh).diagonal();
}

/// The height of a triangle over its longest side; 0 where that has no length.
inline double heightOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    return longest > 0.0 ? glm::length(glm::cross(b - a, c - a)) / longest : 0.0;
}

/// The faces as triples of positions, without those that use a position twice.
std::vector<Triangle> properTriangles(const Mesh& mesh);

/// The corners of a triangle in rising order: equal for all triangles on the same three positions.
Triangle sortedCorners(Triangle t);

} // namespace osgPMObjects::core
