// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// The least-squares plane through heights at horizontal positions. Units: metres.
class NearestPlane
{
public:
    void add(const glm::dvec2& place, double heightM)
    {
        if (_count == 0.0) _origin = place; // far from zero the sums would lose digits
        const glm::dvec3 row(place - _origin, 1.0);
        _products += glm::outerProduct(row, row);
        _sums += row * heightM;
        _count += 1.0;
    }

    /// Computes the plane; level, at the mean height, where the positions are fewer than three or on one
    /// line.
    void fit()
    {
        const double scale = std::max(_products[0][0] + _products[1][1], 1e-12);
        const double plan =
            (_products[0][0] * _products[1][1] - _products[0][1] * _products[1][0]) / (scale * scale);
        const bool isLine = _count < 3.0 || !(plan > 1e-9);
        _plane = isLine ? glm::dvec3(0.0, 0.0, _count > 0.0 ? _sums.z / _count : 0.0)
                        : glm::inverse(_products) * _sums;
    }

    double heightM(const glm::dvec2& place) const
    {
        return glm::dot(_plane, glm::dvec3(place - _origin, 1.0));
    }

private:
    glm::dvec2 _origin{0.0};
    glm::dmat3 _products{0.0};
    glm::dvec3 _sums{0.0}, _plane{0.0};
    double _count = 0.0;
};

} // namespace osgTerrainROAM::core
