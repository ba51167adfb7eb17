// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/field/LeafGrowth.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>

#include "../simplify/ConnectedParts.h"
#include "../simplify/LeafCards.h"
#include "../simplify/UnitFrame.h"

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

double areaOf(const Mesh& mesh, const LevelLadder& ladder, SlotRange range)
{
    double doubled = 0.0;
    for (std::uint32_t f = range.first; f < range.first + range.count; ++f)
    {
        const auto at = [&](int corner)
        { return mesh.positions[mesh.wedgePositions[ladder.faces[f][static_cast<std::size_t>(corner)]]]; };
        doubled += glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    return 0.5 * doubled;
}

/// Whether a group's faces are cards, by the first of them.
bool growsAt(const LevelLadder& ladder, SlotRange range, const std::vector<glm::vec3>& offsets)
{
    return range.count > 0 && offsets[ladder.faces[range.first][0]] != glm::vec3(0.0f);
}

} // namespace

LeafGrowth LeafGrowth::of(const ProgressiveMesh& progressive, const LevelLadder& ladder)
{
    const Mesh& mesh = progressive.mesh;
    const std::vector<std::vector<LeafCard>> cards = cardsOf(meshAfter(progressive, 0));
    LeafGrowth growth;
    if (cards.empty()) return growth;
    growth.offsets.resize(mesh.wedgeCount(), glm::vec3(0.0f));
    for (const std::vector<LeafCard>& ofMaterial : cards)
        for (const LeafCard& card : ofMaterial)
            addOffsets(mesh, card, growth.offsets);
    for (std::uint32_t rung = 0; rung < ladder.rungs.size(); ++rung)
        for (std::uint32_t group = 0; group < ladder.groups; ++group)
        {
            const bool isFoliage = growsAt(ladder, ladder.facesOf(0, group), growth.offsets);
            const double left = isFoliage ? areaOf(mesh, ladder, ladder.facesOf(rung, group)) : 0.0;
            const double lost = left > 0.0 ? areaOf(mesh, ladder, ladder.facesOf(0, group)) / left : 1.0;
            growth.scales.push_back(std::min(kMost, static_cast<float>(std::pow(lost, 0.5 * kShare))));
        }
    return growth;
}

} // namespace osgPMObjects::core
