// SPDX-License-Identifier: Apache-2.0
#include "MirrorTwins.h"

#include <algorithm>
#include <utility>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/PointGrid.h>

#include "PositionAt.h"

namespace osgPMObjects::core
{

namespace
{

constexpr double kLeastMirroredShare = 0.9; ///< of the positions; the rest may be an aerial or a number plate

/// Finds the image of each position across an axis; an image counts only when it is mutual.
MirrorTwins twinsAcross(int axis, std::span<const glm::dvec3> positions, const PointGrid& grid)
{
    MirrorTwins twins{axis, std::vector<std::uint32_t>(positions.size(), MirrorTwins::kNone)};
    for (std::uint32_t p = 0; p < positions.size(); ++p)
        twins.twinOf[p] = positionAt(twins.image(positions[p]), positions, grid);
    for (std::uint32_t p = 0; p < positions.size(); ++p)
    {
        std::uint32_t& twin = twins.twinOf[p];
        if (twin != MirrorTwins::kNone && twins.twinOf[twin] != p) twin = MirrorTwins::kNone;
    }
    return twins;
}

/// Counts the faces with another face as image; `sorted`: all faces by their sorted corners, sorted.
std::size_t pairedFaces(const MirrorTwins& twins, std::span<const Triangle> sorted)
{
    std::size_t paired = 0;
    for (const Triangle& t : sorted)
    {
        const Triangle image = sortedCorners({twins.twinOf[t[0]], twins.twinOf[t[1]], twins.twinOf[t[2]]});
        paired += image != t && std::binary_search(sorted.begin(), sorted.end(), image);
    }
    return paired;
}

} // namespace

MirrorTwins mirrorTwins(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles)
{
    const PointGrid grid = samePlaceGrid(positions);
    std::vector<Triangle> sorted;
    for (const Triangle& t : triangles)
        sorted.push_back(sortedCorners(t));
    std::sort(sorted.begin(), sorted.end());
    const auto enough = kLeastMirroredShare * static_cast<double>(positions.size());
    MirrorTwins best;
    std::pair<std::size_t, std::size_t> most{0, 0}; // numbers of faces and positions
    for (int axis = 0; axis < 3; ++axis)
    {
        MirrorTwins twins = twinsAcross(axis, positions, grid);
        std::size_t inPlane = 0, paired = 0;
        for (std::uint32_t p = 0; p < positions.size(); ++p)
        {
            inPlane += twins.twinOf[p] == p;
            paired += twins.twinOf[p] != p && twins.twinOf[p] != MirrorTwins::kNone;
        }
        if (static_cast<double>(inPlane + paired) < enough) continue;
        const std::pair found{pairedFaces(twins, sorted), paired};
        if (found <= most) continue;
        most = found;
        best = std::move(twins);
    }
    return best;
}

} // namespace osgPMObjects::core
