// SPDX-License-Identifier: Apache-2.0
#include "RoadPieces.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <osgRoads/core/geometry/CubicBounds.h>
#include <osgRoads/core/query/LaneSpan.h>

namespace osgRoads::core
{

namespace
{

constexpr double kPieceM = 20.0, kTurnRad = 0.3;
constexpr double kMostPieces = 200000.0;
constexpr double kTiltReachM = 1.0; ///< heights above a tilted road plane move the surface sideways by less
constexpr double kRoundingM = 1e-6;
constexpr double kBetweenM = 0.01;

/// Adds a side's lanes over a range of one section to the reach of that side.
void includeSide(const Road& road, const LaneSection& section, int sign, double from, double to,
                 ValueRange& reach)
{
    const ValueRange offset = boundsOf(road.laneOffset, from, to);
    double outermost = sign > 0 ? offset.greatest : -offset.least;
    for (const Lane& lane : sign > 0 ? section.left : section.right)
    {
        const ValueRange range = boundsOf(lane.width, from - section.s, to - section.s);
        if (lane.isByBorder)
            outermost = std::max(outermost,
                                 sign > 0 ? offset.greatest + range.greatest : -offset.least - range.least);
        else
            outermost += std::max(range.greatest, 0.0);
    }
    reach.include(sign > 0 ? outermost : -outermost);
}

/// Returns a range of t that holds the lanes between two s.
ValueRange reachOf(const Road& road, double from, double to)
{
    ValueRange reach = boundsOf(road.laneOffset, from, to);
    for (auto i = static_cast<std::size_t>(std::max(lastStartingBy(road.sections, from), 0));
         i < road.sections.size() && road.sections[i].s <= to; ++i)
    {
        const LaneSection& section = road.sections[i];
        const double begin = std::max(from, section.s), end = std::max(begin, std::min(to, section.end));
        includeSide(road, section, 1, begin, end, reach);
        includeSide(road, section, -1, begin, end, reach);
    }
    return reach;
}

int partsOf(const PlanElement& element, double length, double longestM)
{
    double turnRad = 0.0;
    if (const auto* arc = std::get_if<ArcShape>(&element.shape()))
        turnRad = std::fabs(arc->curvature) * length;
    else if (const auto* spiral = std::get_if<Clothoid>(&element.shape()))
        turnRad =
            std::max(std::fabs(spiral->curvatureAt(0.0)), std::fabs(spiral->curvatureAt(length))) * length;
    else if (const auto* cubic = std::get_if<ParametricCubic>(&element.shape()))
        turnRad = cubic->turnBetween(0.0, cubic->parameterAt(length));
    return static_cast<int>(std::ceil(std::max({1.0, length / longestM, turnRad / kTurnRad})));
}

/// The sine of the angle between a direction and the curve at a point; 1 for an obtuse angle.
double sineBetween(glm::dvec2 direction, const PlanPoint& point)
{
    const glm::dvec2 tangent = point.tangent();
    const double sine = std::fabs(direction.x * tangent.y - direction.y * tangent.x);
    return glm::dot(direction, tangent) > 0.0 ? std::min(1.5 * sine, 1.0) : 1.0;
}

RoadPiece pieceOf(const Road& road, const PlanElement& element, double from, double to)
{
    RoadPiece piece;
    piece.from = from;
    piece.to = to;
    const PlanPoint first = element.at(from), last = element.at(to);
    piece.start = first.position;
    const glm::dvec2 chord = last.position - piece.start;
    piece.length = glm::length(chord);
    if (piece.length > 0.0) piece.direction = chord / piece.length;
    const double sagitta = element.sagitta(from, to) + kRoundingM;
    ValueRange reach = reachOf(road, element.s + from, element.s + to);
    reach.include(0.0);
    const double extra = sagitta + (road.hasTilt() ? kTiltReachM : 0.0);
    piece.leftReach = reach.greatest + extra;
    piece.rightReach = -reach.least + extra;
    // Lanes on the outside of a bend reach beyond the ends of the chord, by their width times the sine of the
    // turn.
    const double turn = std::max(sineBetween(piece.direction, first), sineBetween(piece.direction, last));
    piece.sagitta = sagitta + turn * std::max(piece.leftReach, piece.rightReach);
    return piece;
}

/// `end`: s of the next element, or of the end of the road.
void addElement(const Road& road, double end, double longestM, const RoadPiece& which,
                std::vector<RoadPiece>& pieces)
{
    const PlanElement& element = road.referenceLine.elements()[which.element];
    // Rounding may leave a little between elements; the first one goes on there, as it does in ReferenceLine.
    const double length = std::min(element.length + kBetweenM, end - element.s);
    if (!(length > 0.0)) return;
    const int parts = partsOf(element, length, longestM);
    for (int i = 0; i < parts; ++i)
    {
        RoadPiece piece = pieceOf(road, element, length * i / parts, length * (i + 1) / parts);
        piece.road = which.road;
        piece.element = which.element;
        pieces.push_back(piece);
    }
}

} // namespace

double RoadPiece::squareTo(glm::dvec2 point) const
{
    const glm::dvec2 offset = point - start;
    const double along = glm::dot(offset, direction);
    const double left = offset.y * direction.x - offset.x * direction.y;
    const double beyond = std::max({-sagitta - along, along - length - sagitta, 0.0});
    const double beside = std::max({-rightReach - left, left - leftReach, 0.0});
    return beyond * beyond + beside * beside;
}

double RoadPiece::guessAt(glm::dvec2 point) const
{
    const double share = length > 0.0 ? glm::dot(point - start, direction) / length : 0.5;
    return from + (to - from) * std::clamp(share, 0.0, 1.0);
}

PlanBox RoadPiece::box() const
{
    const glm::dvec2 left(-direction.y, direction.x);
    PlanBox box;
    for (const double along : {-sagitta, length + sagitta})
        for (const double across : {-rightReach, leftReach})
            box.include(start + along * direction + across * left);
    return box;
}

std::vector<RoadPiece> piecesOf(const RoadNetwork& network)
{
    const double longestM = std::max(kPieceM, network.usableLengthM() / kMostPieces);
    std::vector<RoadPiece> pieces;
    for (std::size_t road = 0; road < network.roads.size(); ++road)
    {
        if (!network.roads[road].isUsable) continue;
        const std::vector<PlanElement>& elements = network.roads[road].referenceLine.elements();
        for (std::size_t i = 0; i < elements.size(); ++i)
        {
            RoadPiece which;
            which.road = static_cast<std::uint32_t>(road);
            which.element = static_cast<std::uint32_t>(i);
            const double end = i + 1 < elements.size() ? elements[i + 1].s : network.roads[road].length;
            addElement(network.roads[road], std::min(end, network.roads[road].length), longestM, which,
                       pieces);
        }
    }
    return pieces;
}

} // namespace osgRoads::core
