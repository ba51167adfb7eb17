// SPDX-License-Identifier: Apache-2.0
#include "BorderLoop.h"

#include <algorithm>
#include <cmath>

namespace osgTerrainROAM
{

glm::ivec2 BorderLoop::sampleAt(int i) const
{
    if (i < _columns) return {i, 0};
    i -= _columns;
    if (i < _rows) return {_columns, i};
    i -= _rows;
    if (i < _columns) return {_columns - i, _rows};
    return {0, _rows - (i - _columns)};
}

double BorderLoop::positionOf(const glm::dvec2& sample) const
{
    if (sample.y <= 0.0) return sample.x;
    if (sample.x >= _columns) return _columns + sample.y;
    if (sample.y >= _rows) return 2.0 * _columns + _rows - sample.x;
    return length() - sample.y;
}

void BorderLoop::add(double heightM, bool water)
{
    const double share = water ? 1.0 : 0.0;
    _values.emplace_back(heightM, share, heightM * share);
}

void BorderLoop::close()
{
    _values.push_back(_values.front());
    _integrals.assign(1, Sums(0.0));
    for (std::size_t i = 1; i < _values.size(); ++i)
        _integrals.push_back(_integrals.back() + 0.5 * (_values[i - 1] + _values[i]));
}

/// The integral of the linearly interpolated values from position 0, which may lie any number of rounds back.
BorderLoop::Sums BorderLoop::integral(double position) const
{
    const double rounds = std::floor(position / length());
    const double at = std::clamp(position - rounds * length(), 0.0, static_cast<double>(length()));
    const auto i = std::min(static_cast<std::size_t>(at), _values.size() - 2);
    const double t = at - static_cast<double>(i);
    return rounds * _integrals.back() + _integrals[i] +
           t * (_values[i] + 0.5 * t * (_values[i + 1] - _values[i]));
}

BorderLoop::Means BorderLoop::around(double position, double halfWidth) const
{
    const double half = std::clamp(halfWidth, 1e-3, 0.5 * length());
    const Sums mean = (integral(position + half) - integral(position - half)) / (2.0 * half);
    return {mean.x, mean.y, mean.y > 1e-6 ? mean.z / mean.y : mean.x};
}

} // namespace osgTerrainROAM
