// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/selection/BoundingVolumes.h>
#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

/// What an ellipsoid covers of the picture plane, inside the picture or not: the area of the ellipse that it projects to,
/// exact. With half axes A (columns), centre c from the eye, c_z its depth, s = |Aᵀ forward| and P the projection's rows
///     area = π |det P| √(|adj(A) c|² - (det A)²) / (c_z² - s²)^(3/2).
/// It follows from the dual conic P (c cᵀ - A Aᵀ) Pᵀ, whose determinant over the cube of its last entry is that of the
/// ellipse's second moments. The adjugate stands for A⁻¹, so flat ellipsoids have their area, too.
/// kFullArea where it reaches before the near plane. Units: pixels squared. Cost: some 25 ns.
/// Source: paper 004, section 2.3.3, which names ellipsoids and leaves the formula to the reader; dual conics: Hartley &
/// Zisserman, "Multiple view geometry" (2004), 8.3.
double ellipsoidAreaPx(const SelectionView& view, const Ellipsoid& ellipsoid);

} // namespace osgPMObjects::core
