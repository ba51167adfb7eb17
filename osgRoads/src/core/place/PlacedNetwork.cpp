// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

PlacedNetwork::PlacedNetwork(std::shared_ptr<const RoadNetwork> network,
                             std::shared_ptr<const RoadDatum> datum)
    : _network(std::move(network)), _datum(std::move(datum)), _locator(*_network)
{
}

glm::dvec3 PlacedNetwork::point(const RoadPosition& position) const
{
    return toScene(position, worldPosition(*_network, position));
}

glm::dvec3 PlacedNetwork::surfacePoint(int road, double s, double t) const
{
    return point({road, s, t, surfaceHeight(this->road(road), s, t)});
}

glm::dvec3 PlacedNetwork::surfaceAt(const RoadMatch& match, const RoadBed& bed, double mostOutM) const
{
    const auto& [index, s, t, h] = match.position;
    const Road& on = road(index);
    const RoadExtent lanes = extentAt(on, s);
    const double edge = std::clamp(t, lanes.rightT, lanes.leftT);
    const double outM = std::min(match.distance, mostOutM);
    const double leftM = t > edge ? outM : t < edge ? -outM : 0.0; // 0: beyond an end
    const glm::dvec2 beside =
        frameAt(on, s).moved({edge, surfaceHeight(on, s, edge)}, leftM, bed.vergeFall * outM);
    return point({index, s, beside.x, beside.y});
}

} // namespace osgRoads::core
