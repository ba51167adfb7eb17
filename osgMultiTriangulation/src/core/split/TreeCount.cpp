// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgMultiTriangulation/core/split/TreeCount.h>

namespace osgMultiTriangulation::core
{

std::uint32_t balancedTreeCount(double points, const BorderModel& model)
{
    const double count = std::pow(std::pow(points, 1.0 - model.a) / model.c, 1.0 / (2.0 - model.a));
    return static_cast<std::uint32_t>(std::clamp(std::ceil(count), 1.0, 1e6));
}

} // namespace osgMultiTriangulation::core
