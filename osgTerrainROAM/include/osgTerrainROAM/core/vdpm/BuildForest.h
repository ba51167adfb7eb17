// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <osgTerrainROAM/core/vdpm/VertexForest.h>

namespace osgTerrainROAM::core
{

/// An edge collapse: vertex v0 merges into v1.
struct EdgeCollapse
{
    std::uint32_t v0 = 0, v1 = 0;
};

/// What a collapse changes. Faces keep their numbers in the mesh; those at the edge vanish.
struct CollapsedStar
{
    std::uint32_t v0 = 0, v1 = 0;              ///< the vertex that goes, and the one that it merges into
    std::span<const std::uint32_t> faces;      ///< around v0 before the collapse
    std::span<const Triangle> corners;         ///< of these
    std::span<const std::uint32_t> floorFaces; ///< those of them that remain
    std::span<const Triangle> floorCorners;    ///< of these, after the collapse
};

/// Looks at each collapse while a forest is built, from the finest mesh to M0.
class CollapseWitness
{
public:
    virtual ~CollapseWitness() = default;
    /// Returns whether it may be done; one that may not is left out.
    virtual bool collapse(const CollapsedStar& star) = 0;
};

/// Builds the forest of a mesh and a sequence of collapses, finest first. Collapses that would not leave a
/// manifold (there is no such edge, or its ends have other common neighbours than the opposite corners of its
/// faces), or that the witness does not allow, are left out. What is left is M0. Splits are numbered from the
/// last collapse to the first.
/// `triangles`: a manifold, with or without border; vertices that no triangle has are left out.
/// Cost: 1 to 2 µs a collapse. Memory: about 150 B a vertex besides the result.
VertexForest buildForest(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                         std::span<const EdgeCollapse> collapses, CollapseWitness* witness = nullptr);

} // namespace osgTerrainROAM::core
