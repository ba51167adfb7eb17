// SPDX-License-Identifier: Apache-2.0
#include "OutlineRows.h"

#include <algorithm>
#include <cmath>

#include <foundation/NearestOnSegment.h>
#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kRowM = 25.0;

} // namespace

OutlineRows::OutlineRows(const std::vector<std::vector<glm::dvec2>>& rings)
{
    double high = -1e300;
    _lowY = 1e300;
    for (const auto& ring : rings)
        for (const glm::dvec2& point : ring)
        {
            _lowY = std::min(_lowY, point.y);
            high = std::max(high, point.y);
        }
    _rows.resize(high < _lowY ? 1 : static_cast<std::size_t>((high - _lowY) / kRowM) + 1);
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const Edge edge{ring[i], ring[(i + 1) % ring.size()]};
            for (int row = rowOf(std::min(edge.a.y, edge.b.y)); row <= rowOf(std::max(edge.a.y, edge.b.y));
                 ++row)
                _rows[static_cast<std::size_t>(row)].push_back(edge);
        }
}

int OutlineRows::rowOf(double y) const
{
    return static_cast<int>(
        std::clamp(std::floor((y - _lowY) / kRowM), 0.0, static_cast<double>(_rows.size() - 1)));
}

bool OutlineRows::contains(const glm::dvec2& place) const
{
    bool isInside = false;
    for (const Edge& edge : _rows[static_cast<std::size_t>(rowOf(place.y))])
        if ((edge.a.y > place.y) != (edge.b.y > place.y) &&
            place.x < edge.a.x + (edge.b.x - edge.a.x) * (place.y - edge.a.y) / (edge.b.y - edge.a.y))
            isInside = !isInside;
    return isInside;
}

double OutlineRows::distanceM(const glm::dvec2& place, double withinM) const
{
    double least = withinM;
    for (int row = rowOf(place.y - withinM); row <= rowOf(place.y + withinM); ++row)
        for (const Edge& edge : _rows[static_cast<std::size_t>(row)])
        {
            least =
                std::min(least, glm::distance(place, foundation::nearestOnSegment(place, edge.a, edge.b)));
        }
    return least;
}

} // namespace osgTerrainROAM::core
