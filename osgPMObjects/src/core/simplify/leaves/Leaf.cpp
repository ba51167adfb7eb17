// SPDX-License-Identifier: Apache-2.0
#include "Leaf.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgPMObjects::core
{

namespace
{

constexpr double kLeastExposure = 0.02; ///< of any card among others: it may be visible between them

constexpr double kWidening =
    0.02; // of a box at each side, as a share of its size, for each doubling of its cards

glm::dvec3 middleOfBoth(const Leaf& a, const Leaf& b)
{
    return (a.seenDoubleArea * a.middle + b.seenDoubleArea * b.middle) /
           (a.seenDoubleArea + b.seenDoubleArea);
}

} // namespace

glm::dvec3 centroidOf(std::span<const glm::dvec3> places)
{
    return std::accumulate(places.begin(), places.end(), glm::dvec3(0.0)) / double(places.size());
}

std::vector<glm::dvec3> cornerPositions(const CollapseState& state, const LeafCard& card)
{
    std::vector<glm::dvec3> places;
    for (const LeafCard::Corner& corner : card.corners)
        places.push_back(state.positions[corner.position]);
    return places;
}

glm::dvec3 doubleAreaVector(const LeafCard::Corners& c, std::span<const glm::dvec3> places)
{
    return glm::cross(places[c[1]] - places[c[0]], places[c[2]] - places[c[0]]);
}

double doubleAreaOf(const LeafCard& card, std::span<const glm::dvec3> places)
{
    double area = 0.0;
    for (const LeafCard::Corners& corners : card.faces)
        area += glm::length(doubleAreaVector(corners, places));
    return area;
}

Leaf::Leaf(const CollapseState& state, LeafCard given) : card(std::move(given))
{
    const auto places = cornerPositions(state, card);
    middle = centroidOf(places);
    extent = extentOf(places);
    owedDoubleArea = doubleAreaOf(card, places);
    const double reach = state.parts[card.part].reach / (0.5 * extent.diagonal());
    exposure = std::max(kLeastExposure, reach * reach);
    seenDoubleArea = exposure * owedDoubleArea;
}

Extent Leaf::room(const Extent& box) const
{
    const glm::dvec3 wider = kWidening * std::log2(double(count)) * (extent.high - extent.low);
    Extent room;
    room.add(glm::max(extent.low - wider, box.low));
    room.add(glm::min(extent.high + wider, box.high));
    return room;
}

void Leaf::takeOver(const Leaf& gone)
{
    middle = middleOfBoth(*this, gone);
    count += gone.count;
    owedDoubleArea += gone.owedDoubleArea;
    seenDoubleArea += gone.seenDoubleArea;
    extent.add(gone.extent.low);
    extent.add(gone.extent.high);
}

} // namespace osgPMObjects::core
