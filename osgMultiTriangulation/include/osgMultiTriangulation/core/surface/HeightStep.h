// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace osgMultiTriangulation::core
{

/// Finds the step of commonHeightStep() height by height.
class HeightStep
{
public:
    void add(double height)
    {
        while (_step >= 0x1p-20 && height / _step != std::floor(height / _step))
            _step /= 2.0;
        _most = std::max(_most, std::abs(height));
    }

    double step() const { return _step >= 0x1p-20 && _most / _step < 0x1p28 ? _step : 0.0; }

private:
    double _step = 1.0, _most = 0.0;
};

} // namespace osgMultiTriangulation::core
