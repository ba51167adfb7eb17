// SPDX-License-Identifier: Apache-2.0
#include "OpenEnds.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "JunctionCover.h"

namespace osgRoads::core
{

namespace
{

constexpr double kNearM = 2.0; ///< another road's lanes, or the road's other end
constexpr double kShortestOpenM = 3.0 * OpenEnds::kWearM;

/// Whether a bridge or tunnel reaches into the wear of an end.
bool hasStructureNear(const Road& road, double s)
{
    return std::any_of(road.structures.begin(), road.structures.end(),
                       [s](const RoadStructure& structure) {
                           return structure.s < s + OpenEnds::kWearM &&
                                  structure.s + structure.length > s - OpenEnds::kWearM;
                       });
}

bool isOpen(const PlacedNetwork& network, int index, double s, const std::optional<RoadLink>& link)
{
    const Road& road = network.road(index);
    if (link || road.junction >= 0 || road.length < kShortestOpenM || hasStructureNear(road, s)) return false;
    const glm::dvec2 start = road.referenceLine.at(0.0).position,
                     end = road.referenceLine.at(road.length).position;
    return glm::distance(start, end) > kNearM && !JunctionCover(network, index).isNearOther(s, kNearM);
}

} // namespace

OpenEnds::OpenEnds(const PlacedNetwork& network, int road)
    : _length(network.road(road).length),
      _isStartOpen(isOpen(network, road, 0.0, network.road(road).predecessor)),
      _isEndOpen(isOpen(network, road, _length, network.road(road).successor))
{
}

std::vector<double> OpenEnds::cuts() const
{
    std::vector<double> cuts;
    if (_isStartOpen) cuts.push_back(kWearM);
    if (_isEndOpen) cuts.push_back(_length - kWearM);
    return cuts;
}

double OpenEnds::wearAt(double s) const
{
    const double start = _isStartOpen ? 1.0 - s / kWearM : 0.0,
                 end = _isEndOpen ? 1.0 - (_length - s) / kWearM : 0.0;
    return std::clamp(std::max(start, end), 0.0, 1.0);
}

} // namespace osgRoads::core
