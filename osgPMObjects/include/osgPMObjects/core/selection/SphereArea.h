// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/selection/BoundingVolumes.h>
#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

/// What a sphere covers of the picture plane, inside the picture or not: the area of the ellipse that it projects to, exact.
/// With the centre at depth c_z and distance d from the eye
///     area = π |det P| r² √(d² - r²) / (c_z² - r²)^(3/2),
/// what ellipsoidAreaPx() becomes for equal half axes. Towards the picture's edges it is larger than π (K r / d)².
/// kFullArea where it reaches before the near plane. Units: pixels squared. Cost: some 10 ns.
/// Source: paper 004, section 2.3.3.
double sphereAreaPx(const SelectionView& view, const BoundingSphere& sphere);

} // namespace osgPMObjects::core
