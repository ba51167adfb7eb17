// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgMultiTriangulation::core
{

/// Where the lattice of the plan lies: place = origin + step · lattice.
/// Units: metres, or those of the input.
struct PlanFrame
{
    double originX = 0.0, originY = 0.0;
    double stepX = 1.0, stepY = 1.0;

    bool operator==(const PlanFrame&) const = default;
};

} // namespace osgMultiTriangulation::core
