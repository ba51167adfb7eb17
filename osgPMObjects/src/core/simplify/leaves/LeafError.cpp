// SPDX-License-Identifier: Apache-2.0
#include "LeafError.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/TriangleDistance.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

double distanceTo(const LeafCard& card, std::span<const glm::dvec3> places, const glm::dvec3& from)
{
    double squared = std::numeric_limits<double>::infinity();
    for (const LeafCard::Corners& c : card.faces)
    {
        const glm::dvec3 away = from - nearestPoint(from, places[c[0]], places[c[1]], places[c[2]]);
        squared = std::min(squared, glm::dot(away, away));
    }
    return std::sqrt(squared);
}

} // namespace

LevelError leafError(const CollapseState& state, const Leaf& gone, const Leaf& stays,
                     const LeafGrowth& growth)
{
    const std::vector<glm::dvec3> ofGone = cornerPositions(state, gone.card),
                                  before = cornerPositions(state, stays.card);
    double distance = 0.0;
    for (const glm::dvec3& p : ofGone)
        distance = std::max(distance, distanceTo(stays.card, growth.places, p));
    for (const glm::dvec3& p : growth.places)
        distance =
            std::max(distance, std::min(distanceTo(stays.card, before, p), distanceTo(gone.card, ofGone, p)));
    const Wedge a = wedgeOf(state.mesh, gone.card.corners.front().wedges.front());
    const Wedge b = wedgeOf(state.mesh, stays.card.corners.front().wedges.front());
    Leaf both = stays; // nothing of either is outside of its room
    both.takeOver(gone);
    distance = std::min(distance + std::max(gone.error.distance, stays.error.distance),
                        both.room(state.box).diagonal());
    LevelError error{
        float(distance), std::max({gone.error.normal, stays.error.normal, glm::distance(a.normal, b.normal)}),
        std::max(gone.error.texCoord, stays.error.texCoord), std::max(gone.error.colour, stays.error.colour)};
    for (int channel = 0; channel < 4; ++channel)
        error.colour = std::max(error.colour, std::abs(a.colour[channel] - b.colour[channel]));
    return error;
}

} // namespace osgPMObjects::core
