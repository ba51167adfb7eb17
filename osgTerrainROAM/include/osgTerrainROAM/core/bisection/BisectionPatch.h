// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

#include <osgTerrainROAM/core/bisection/BisectionSurface.h>

namespace osgTerrainROAM::core
{

/// A point inside a triangle of a bintree, placed anywhere.
struct PatchPoint
{
    glm::dvec3 weights{0.0}; ///< shares of left, right and apex; their sum is 1
    glm::dvec3 point{0.0};
};

/// A TIN that takes the place of all that is below a triangle of a bintree, the *carrier*. While the carrier
/// is a leaf it is drawn as any other; when it would split, the TIN is drawn instead. Its border is locked:
/// it has the vertices that the sides of the carrier have at the finest level, and no others. So neighbours
/// are plain leaves, or other patches, without a crack.
/// Invariant: checkPatch().
struct BisectionPatch
{
    Bisector carrier;                  ///< above the last level
    std::vector<std::uint32_t> border; ///< vertices of the surface, counter-clockwise from the left corner
    std::vector<PatchPoint> points;    ///< those of the border first, in the same order
    std::vector<CornerVertices> triangles; ///< corners are numbers in `points`
};

/// Makes a patch from points inside a triangle: their Delaunay triangulation in the plane of the weights,
/// with the border. Points less than 2^-20 of a side from another are left out.
BisectionPatch makePatch(const BisectionSurface& surface, Bisector carrier,
                         std::span<const PatchPoint> inside);

/// Checks by brute force that a patch covers its carrier once, that its border is that of the carrier, and
/// that border points lie where the surface has them. Returns what is wrong.
std::optional<std::string> checkPatch(const BisectionSurface& surface, const BisectionPatch& patch);

/// Finds patches by their carriers.
class CarrierTable
{
public:
    explicit CarrierTable(std::span<const BisectionPatch> patches);

    /// Returns the number of the patch of a triangle, kNoSide where there is none.
    std::uint32_t at(Bisector t) const;

    /// Whether a triangle lies in a carrier, and is not the carrier itself.
    bool isBelowCarrier(Bisector t) const;

private:
    std::unordered_map<std::uint64_t, std::uint32_t> _byCarrier;
};

} // namespace osgTerrainROAM::core
