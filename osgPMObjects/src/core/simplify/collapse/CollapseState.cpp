// SPDX-License-Identifier: Apache-2.0
#include "CollapseState.h"

#include <algorithm>
#include <numeric>

#include <osgPMObjects/core/mesh/MeshCounts.h>

#include "../parts/NearbyParts.h"

namespace osgPMObjects::core
{

namespace
{

AreaWeight weightFor(Placement placement, std::size_t faces)
{
    // The usual double area of a face where the diagonal is 1: the surface of a solid is about the square of
    // that.
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

std::unique_ptr<Mesh> withoutPositions(const Mesh& mesh)
{
    auto copy = std::make_unique<Mesh>(mesh);
    copy->positions = {};
    return copy;
}

/// Finds the foliage, unless the mesh is kept symmetric (cards would have to be merged in pairs of pairs) or
/// has an envelope.
std::vector<std::vector<LeafCard>> foliageOf(const CollapseState& state, const Mesh& original)
{
    const SimplifySettings& settings = state.settings;
    if (!settings.growLeaves || settings.envelope > 0.0 || settings.joinDistance > 0.0 ||
        state.twins.isMirrored() || state.orbits.isRound())
        return {};
    return leafCards(original, state.positions, state.parts, state.partOf);
}

} // namespace

CollapseState::CollapseState(const Mesh& original, const SimplifySettings& given)
    : settings(given),
      weight(weightFor(given.placement, original.faces.size())),
      movedMesh(given.placement == Placement::subset ? nullptr : withoutPositions(original)),
      mesh(movedMesh ? *movedMesh : original),
      frame(original.positions),
      positions(frame.unit(original.positions)),
      box(extentOf(positions)),
      stars(original),
      orbits(given.keepSymmetry ? rotationOrbits(positions, positionTriangles(original)) : RotationOrbits()),
      twins(given.keepSymmetry && !orbits.isRound() ? mirrorTwins(positions, positionTriangles(original))
                                                    : MirrorTwins()),
      parts(connectedParts(original, positions, given.materialColours)),
      partOf(partNumbers(parts, positions.size())),
      foliage(foliageOf(*this, original)),
      areaCost(AreaCost::forModel(given, meanSize(parts, positions), !foliage.empty())),
      shapes(positions.size()),
      accumulated(given.quadrics == Quadrics::accumulated ? positions.size() : 0),
      errors(positions.size()),
      changes(positions.size(), 0),
      candidates(positions.size())
{
    joinedTo.resize(parts.size());
    std::iota(joinedTo.begin(), joinedTo.end(), 0u);
    wentTo.resize(positions.size());
    std::iota(wentTo.begin(), wentTo.end(), 0u);
    const double join = settings.joinDistance / frame.diagonal();
    if (join > 0.0 && settings.joinWithinParts)
        nearby = nearestAcrossGaps(positions, positionTriangles(original), join);
    else if (join > 0.0 && parts.size() > 1)
        nearby = nearestOfOtherParts(positions, partOf, join);
    if (settings.envelope > 0.0)
        envelope = std::make_unique<Envelope>(positions, properTriangles(original),
                                              settings.envelope / frame.diagonal());
}

std::uint32_t CollapseState::nearbyNow(std::uint32_t position) const
{
    constexpr std::uint32_t kNone = ~0u;
    if (nearby.empty() || nearby[position] == kNone) return kNone;
    const std::uint32_t now = followed(wentTo, nearby[position]);
    if (!stars.hasFaces(now) || now == position) return kNone;
    return settings.joinWithinParts || partNumber(now) != partNumber(position) ? now : kNone;
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
