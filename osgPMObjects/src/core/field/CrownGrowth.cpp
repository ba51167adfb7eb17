// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/field/CrownGrowth.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>

#include "../simplify/collapse/UnitFrame.h"
#include "../simplify/parts/ConnectedParts.h"
#include "../simplify/parts/LeafCards.h"

namespace osgPMObjects::core
{

namespace
{

std::vector<std::vector<LeafCard>> cardsOf(const Mesh& finest)
{
    const UnitFrame frame(finest.positions);
    const std::vector<glm::dvec3> positions = frame.unit(finest.positions);
    const std::vector<ConnectedPart> parts = connectedParts(finest, positions);
    return leafCards(finest, positions, parts, partNumbers(parts, positions.size()));
}

void addOffsets(const Mesh& mesh, const LeafCard& card, std::vector<glm::vec3>& offsets)
{
    glm::dvec3 middle(0.0);
    for (const LeafCard::Corner& corner : card.corners)
        middle += mesh.positions[corner.position] / static_cast<double>(card.corners.size());
    for (const LeafCard::Corner& corner : card.corners)
        for (const std::uint32_t wedge : corner.wedges)
            offsets[wedge] = mesh.positions[corner.position] - middle;
}

/// Returns the area of faces whose cards are grown by a factor.
double areaOf(const Mesh& mesh, std::span<const Triangle> faces, const std::vector<glm::vec3>& offsets,
              double scale)
{
    double doubled = 0.0;
    for (const Triangle& face : faces)
    {
        const auto at = [&](std::size_t corner)
        {
            return mesh.positions[mesh.wedgePositions[face[corner]]] +
                   (scale - 1.0) * glm::dvec3(offsets[face[corner]]);
        };
        doubled += glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    return 0.5 * doubled;
}

/// Returns the factor that restores kShare of the lost area. It is found by bisection, for the area of cards
/// whose corners moved to those of others is not proportional to its square.
double scaleOf(const Mesh& mesh, std::span<const Triangle> faces, const std::vector<glm::vec3>& offsets,
               double whole)
{
    const double left = areaOf(mesh, faces, offsets, 1.0);
    if (!(left > 0.0) || left >= whole) return 1.0;
    const double wanted = left * std::pow(whole / left, CrownGrowth::kShare);
    double low = 1.0, high = CrownGrowth::kMost;
    for (int i = 0; i < 20; ++i)
    {
        const double middle = 0.5 * (low + high);
        (areaOf(mesh, faces, offsets, middle) < wanted ? low : high) = middle;
    }
    return low;
}

/// Tells whether faces are leaf cards, by the first one.
bool areCards(std::span<const Triangle> faces, const std::vector<glm::vec3>& offsets)
{
    return !faces.empty() && offsets[faces.front()[0]] != glm::vec3(0.0f);
}

} // namespace

CrownGrowth CrownGrowth::of(const ProgressiveMesh& progressive, const LevelLadder& ladder)
{
    const Mesh& mesh = progressive.mesh;
    const std::vector<std::vector<LeafCard>> cards = cardsOf(meshAfter(progressive, 0));
    CrownGrowth growth;
    if (cards.empty()) return growth;
    growth.offsets.resize(mesh.wedgeCount(), glm::vec3(0.0f));
    for (const std::vector<LeafCard>& ofMaterial : cards)
        for (const LeafCard& card : ofMaterial)
            addOffsets(mesh, card, growth.offsets);
    const auto facesOf = [&](std::uint32_t rung, std::uint32_t group)
    {
        const SlotRange range = ladder.facesOf(rung, group);
        return std::span(ladder.faces).subspan(range.first, range.count);
    };
    growth.scales.assign(ladder.rungs.size() * ladder.groups, 1.0f);
    for (std::uint32_t group = 0; group < ladder.groups; ++group)
    {
        if (!areCards(facesOf(0, group), growth.offsets)) continue;
        const double whole = areaOf(mesh, facesOf(0, group), growth.offsets, 1.0);
        for (std::uint32_t rung = 1; rung < ladder.rungs.size(); ++rung)
            growth.scales[rung * ladder.groups + group] =
                static_cast<float>(scaleOf(mesh, facesOf(rung, group), growth.offsets, whole));
    }
    return growth;
}

} // namespace osgPMObjects::core
