// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/roam/RoamTile.h>
#include <osgTerrainROAM/core/vdpm/NormalCone.h>
#include <osgTerrainROAM/core/vdpm/VertexForest.h>

namespace osgTerrainROAM::core
{

/// A vertex forest, where its vertices are, and bounds by which a view decides on its splits.
/// The bound of split w: error e_w ≥ the error of every face that w changes, over all samples in it; and a
/// ball around all of these faces and samples. Where w is not done and its dependencies are, no sample of
/// them is off by more. Bounds *nest* along one dependency of each split, its *finder*: e of the finder is no
/// less, and its ball contains that of w. So who looks only at splits whose finder is wanted misses none that
/// is wanted. (ROAM nests bounds along all dependencies; here these would reach far to the side, so others
/// are forced instead.) With cones, a split has the normals of all faces and samples that its ball stands
/// for; they nest likewise.
/// Invariant: areBoundsNested(). Frame and units: those of the positions, metres.
struct BoundedForest
{
    VertexForest forest;
    std::vector<glm::dvec3> positions;     ///< by vertex
    std::vector<SplitBound> bounds;        ///< by split
    std::vector<NormalCone> cones;         ///< by split, or empty: orientation is not known
    std::vector<std::uint32_t> finder;     ///< by split: a split with a smaller number, or kNone
    std::vector<std::uint32_t> firstFound; ///< by split: the first in `found`; one more at the end
    std::vector<std::uint32_t> found;      ///< splits by their finder
    std::vector<std::uint32_t> unfound;    ///< splits without one: they depend on nothing

    std::span<const std::uint32_t> foundBy(std::uint32_t split) const
    {
        return std::span(found).subspan(firstFound[split], firstFound[split + 1] - firstFound[split]);
    }

    std::size_t memoryBytes() const
    {
        return forest.memoryBytes() + positions.size() * sizeof(glm::dvec3) +
               bounds.size() * sizeof(SplitBound) + cones.size() * sizeof(NormalCone) +
               sizeof(std::uint32_t) * (finder.size() + firstFound.size() + found.size() + unfound.size());
    }
};

/// Chooses finders and nests the bounds along them: for each split, from the finest on, the dependency whose
/// bound has to grow least, a small one rather than a large. `bounds` and `cones`: by split, each for itself.
/// Cost: linear.
BoundedForest nestBounds(VertexForest forest, std::vector<glm::dvec3> positions,
                         std::vector<SplitBound> bounds, std::vector<NormalCone> cones = {});

bool areBoundsNested(const BoundedForest& forest);

} // namespace osgTerrainROAM::core
