// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace osgTerrainROAM
{

/// One axis of the maps and the mesh of the surroundings. Its texels divide the data evenly; beyond the data
/// they grow exponentially with the distance, so that a few reach the horizon: texel k beyond the border lies
/// scale·(e^(k / curve) − 1) grid units from it.
/// Units: grid coordinates of the tile; texels, counted from the first one.
class OuterAxis
{
public:
    static constexpr int kInside = 256;  ///< texels that the data are divided into
    static constexpr int kOutside = 128; ///< texels on either side of the data
    static constexpr int kTexels = kInside + 2 * kOutside + 1;

    /// `reach`: how far the axis goes beyond the data, more than kOutside texels of the inside.
    OuterAxis(double last, double reach) : _last(last), _inside(last / kInside)
    {
        double low = 1.0, high = 1e4; // of the curve: a small one grows faster
        for (int i = 0; i < 60; ++i)
        {
            const double middle = 0.5 * (low + high);
            (middle * _inside * std::expm1(kOutside / middle) > reach ? low : high) = middle;
        }
        _curve = high;
    }

    double gridAt(double texel) const
    {
        if (texel < kOutside) return -beyond(kOutside - texel);
        if (texel > kOutside + kInside) return _last + beyond(texel - kOutside - kInside);
        return (texel - kOutside) * _inside;
    }

    /// Grid units per texel at a grid position.
    double spacingAt(double grid) const
    {
        const double beyond = grid < 0.0 ? -grid : grid > _last ? grid - _last : 0.0;
        return _inside + beyond / _curve;
    }

    double last() const { return _last; }
    double curve() const { return _curve; }
    double inside() const { return _inside; } ///< grid units per texel within the data

private:
    double beyond(double texels) const { return _curve * _inside * std::expm1(texels / _curve); }

    double _last, _inside, _curve;
};

} // namespace osgTerrainROAM
