// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace osgMultiTriangulation::core
{

/// The mean number of points on the border of a part with n points, modelled as c·n^a. Such points stay until
/// the parts on both sides are joined.
struct BorderModel
{
    double c = 4.7;
    double a = 0.5; ///< the border of an area grows like its root; the paper has 1/3
};

/// Returns the number of parts for which a part has as many points as stay on all borders together:
/// ⌈(N^(1−a)/c)^(1/(2−a))⌉, at least 1. `points`: N.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), section 3.
/// Differs: the exponent is a parameter.
std::uint32_t balancedTreeCount(double points, const BorderModel& model = {});

} // namespace osgMultiTriangulation::core
