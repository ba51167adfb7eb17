// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgRoads/core/place/PlacedNetwork.h>
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
    const glm::dvec3 inertial = worldPosition(*_network, position);
    return _datum ? _datum->toScene(position, inertial) : inertial;
}

glm::dvec3 PlacedNetwork::surfacePoint(int road, double s, double t) const
{
    return point({road, s, t, surfaceHeight(this->road(road), s, t)});
}

} // namespace osgRoads::core
