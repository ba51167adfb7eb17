// SPDX-License-Identifier: Apache-2.0
#include "CollapseState.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <osgPMObjects/core/mesh/MeshCounts.h>

#include "NearbyParts.h"

namespace osgPMObjects::core
{

namespace
{

AreaWeight weightFor(Placement placement, std::size_t faces)
{
    // Areas are twice a face's, where the diagonal is 1; a solid's surface is about as large as the square of that.
    const double usual = 1.0 / static_cast<double>(std::max<std::size_t>(faces, 1));
    switch (placement)
    {
    case Placement::subset:
        return {1.0, 0.1 * usual};
    case Placement::optimal:
        return {1.5, 0.1 * usual};
    case Placement::quality:
        break;
    }
    return {2.0, 0.0};
}

/// In a frame where the diagonal of the box is 1 and its middle the origin.
std::vector<glm::dvec3> unitPositions(const Mesh& mesh)
{
    const Extent extent = extentOf(mesh.positions);
    const glm::dvec3 middle = 0.5 * (extent.low + extent.high);
    const double scale = extent.diagonal() > 0.0 ? 1.0 / extent.diagonal() : 1.0;
    std::vector<glm::dvec3> positions;
    positions.reserve(mesh.positions.size());
    for (const glm::dvec3& p : mesh.positions)
        positions.push_back((p - middle) * scale);
    return positions;
}

std::unique_ptr<Mesh> withoutPositions(const Mesh& mesh)
{
    auto copy = std::make_unique<Mesh>(mesh);
    copy->positions = {};
    return copy;
}

} // namespace

CollapseState::CollapseState(const Mesh& original, const SimplifySettings& given)
    : settings(given),
      weight(weightFor(given.placement, original.faces.size())),
      movedMesh(given.placement == Placement::subset ? nullptr : withoutPositions(original)),
      mesh(movedMesh ? *movedMesh : original),
      positions(unitPositions(original)),
      box(extentOf(positions)),
      stars(original),
      twins(given.keepSymmetry ? mirrorTwins(positions, positionTriangles(original)) : MirrorTwins()),
      parts(connectedParts(original, positions)),
      partOf(partNumbers(parts, positions.size())),
      shapes(positions.size()),
      errors(positions.size()),
      changes(positions.size(), 0),
      candidates(positions.size())
{
    joinedTo.resize(parts.size());
    std::iota(joinedTo.begin(), joinedTo.end(), 0u);
    wentTo.resize(positions.size());
    std::iota(wentTo.begin(), wentTo.end(), 0u);
    const double diagonal = extentOf(original.positions).diagonal();
    if (settings.joinDistance > 0.0 && parts.size() > 1)
        nearby = nearestOfOtherParts(positions, partOf, settings.joinDistance / diagonal);
    if (settings.envelope <= 0.0) return;
    std::vector<Triangle> triangles = positionTriangles(original);
    std::erase_if(triangles, [](const Triangle& t) { return repeatsCorner(t); });
    envelope = std::make_unique<Envelope>(positions, std::move(triangles), settings.envelope / diagonal);
}

std::uint32_t CollapseState::nearbyNow(std::uint32_t position) const
{
    constexpr std::uint32_t kNone = ~0u;
    if (nearby.empty() || nearby[position] == kNone) return kNone;
    const std::uint32_t now = followed(wentTo, nearby[position]);
    return stars.hasFaces(now) && partNumber(now) != partNumber(position) ? now : kNone;
}

void CollapseState::joinParts(std::uint32_t from, std::uint32_t to)
{
    const std::uint32_t gone = partNumber(from), stays = partNumber(to);
    if (gone == stays) return;
    joinedTo[gone] = stays;
    ConnectedPart &part = parts[stays], &other = parts[gone];
    part.faces += other.faces;
    part.doubleArea += other.doubleArea;
    part.reach = std::max(part.reach, other.reach);
    part.kept.insert(part.kept.end(), other.kept.begin(), other.kept.end());
}

} // namespace osgPMObjects::core
