// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/heightfield/PlanExpansion.h>

namespace osgTerrainROAM::core
{

PlanExpansion::PlanExpansion(int side, const std::function<glm::dvec2(double, double)>& planAt)
{
    const double d = 0.5 * (side - 1);
    const auto at = [&](int east, int north) { return planAt(d + east * d, d + north * d); };
    const glm::dvec2 west = at(-1, 0), east = at(1, 0), south = at(0, -1), north = at(0, 1);
    _grid = glm::dvec2(d);
    _local = at(0, 0);
    _inverse = glm::inverse(glm::dmat2(east - west, north - south) / (2.0 * d));
    _xx = (east + west - 2.0 * _local) / (2.0 * d * d);
    _yy = (north + south - 2.0 * _local) / (2.0 * d * d);
    _xy = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4.0 * d * d);
}

glm::dvec2 PlanExpansion::gridNear(const glm::dvec2& local) const
{
    // The first-order solution is put into the second-order terms.
    const glm::dvec2 offset = local - _local;
    const glm::dvec2 d = _inverse * offset;
    const glm::dvec2 bent = d.x * d.x * _xx + d.x * d.y * _xy + d.y * d.y * _yy;
    return _grid + _inverse * (offset - bent);
}

} // namespace osgTerrainROAM::core
