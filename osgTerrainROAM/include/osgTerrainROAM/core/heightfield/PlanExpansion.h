// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// The second-order Taylor expansion of a tile's horizontal position by grid coordinates about the tile's
/// middle: local(grid) = local₀ + J·d + d.x²·xx + d.x·d.y·xy + d.y²·yy, where d = grid − grid₀. Derivatives
/// are central differences between the tile's nine corners, edge middles and centre.
class PlanExpansion
{
public:
    PlanExpansion() = default;

    /// `side`: grid points along the tile; `planAt(column, row)`: horizontal position.
    PlanExpansion(int side, const std::function<glm::dvec2(double, double)>& planAt);

    /// Grid coordinates of a horizontal position, to second order.
    glm::dvec2 gridNear(const glm::dvec2& local) const;

    /// Grid coordinates to first order: linear · local + offset.
    const glm::dmat2& linear() const { return _inverse; }
    glm::dvec2 offset() const { return _grid - _inverse * _local; }

private:
    glm::dvec2 _grid{0.0}, _local{0.0};
    glm::dmat2 _inverse{1.0}; ///< of J
    glm::dvec2 _xx{0.0}, _xy{0.0}, _yy{0.0};
};

} // namespace osgTerrainROAM::core
