// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/RoadsInScene.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace scenery
{

namespace
{

using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;
using osgRoads::core::PlacedNetwork;
using osgRoads::core::PlanElement;
using osgRoads::core::Road;

constexpr double kKnotM = 250.0; ///< between places where the lift of a road is measured

/// One road as it is placed.
class PlacedRoad
{
public:
    PlacedRoad(const PlacedNetwork& roads, int index)
        : _roads(roads), _index(index), _road(roads.network().roads[static_cast<std::size_t>(index)])
    {
    }

    std::vector<PlanElement> elements() const
    {
        std::vector<PlanElement> placed;
        for (const PlanElement& element : _road.referenceLine.elements())
        {
            const auto start = element.at(0.0);
            placed.emplace_back(element.s, element.length, glm::dvec2(at(element.s)),
                                start.headingRad + turnOf(element), element.shape());
        }
        return placed;
    }

    /// The heights with their lift, in pieces of a knot's length at most.
    CubicProfile elevation() const
    {
        std::vector<double> starts{0.0};
        for (const Cubic& piece : _road.elevation.pieces())
            starts.push_back(piece.s);
        const int knots = std::max(1, static_cast<int>(std::ceil(_road.length / kKnotM)));
        for (int i = 1; i < knots; ++i)
            starts.push_back(_road.length * i / knots);
        std::sort(starts.begin(), starts.end());
        starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
        std::vector<Cubic> pieces;
        for (std::size_t i = 0; i < starts.size(); ++i)
            pieces.push_back(liftedPiece(starts[i], i + 1 < starts.size() ? starts[i + 1] : _road.length));
        return CubicProfile(std::move(pieces));
    }

private:
    glm::dvec3 at(double s) const { return _roads.point({_index, s, 0.0, 0.0}); }

    double liftAt(double s) const { return at(s).z - _road.elevation.value(s); }

    /// By what an element is turned where it is placed. One that ends where it begins is judged by its first
    /// quarter.
    double turnOf(const PlanElement& element) const
    {
        double length = element.length;
        glm::dvec2 way = element.at(length).position - element.at(0.0).position;
        if (glm::length(way) < 0.01 * length)
        {
            length *= 0.25;
            way = element.at(length).position - element.at(0.0).position;
        }
        const glm::dvec2 placed(at(element.s + length) - at(element.s));
        return std::atan2(way.x * placed.y - way.y * placed.x, glm::dot(way, placed));
    }

    Cubic liftedPiece(double from, double to) const
    {
        Cubic piece{.s = from};
        if (const Cubic* const old = _road.elevation.pieceAt(from))
        {
            const double ds = from - old->s;
            piece = {from, old->value(from), old->slope(from), old->c + 3.0 * old->d * ds, old->d};
        }
        const double lift = liftAt(from);
        piece.a += lift;
        // The end's own height may be that of the next piece, after a step.
        const double lengthM = to - from;
        if (lengthM > 1e-3) piece.b += (liftAt(std::nextafter(to, from)) - lift) / lengthM;
        return piece;
    }

    const PlacedNetwork& _roads;
    int _index;
    const Road& _road;
};

} // namespace

osgRoads::core::RoadNetwork roadsInScene(const PlacedNetwork& roads)
{
    osgRoads::core::RoadNetwork network = roads.network();
    for (std::size_t i = 0; i < network.roads.size(); ++i)
    {
        Road& road = network.roads[i];
        if (!road.isUsable || !(road.length > 0.0)) continue;
        const PlacedRoad placed(roads, static_cast<int>(i));
        road.referenceLine = osgRoads::core::ReferenceLine(placed.elements());
        road.elevation = placed.elevation();
    }
    network.header.geoReference.clear();
    network.header.offsetX = network.header.offsetY = network.header.offsetZ =
        network.header.offsetHeadingRad = 0.0;
    return network;
}

} // namespace scenery
