// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/selection/BoundingVolumes.h>
#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

/// Computes the area of an ellipsoid projected onto the image plane, also outside the image; exact. With half
/// axes A (columns), centre c from the eye, its depth c_z, s = |Aᵀ forward| and the rows P of the projection:
///     area = π |det P| √(|adj(A) c|² - (det A)²) / (c_z² - s²)^(3/2).
/// This follows from the dual conic P (c cᵀ - A Aᵀ) Pᵀ: its determinant over the cube of its last entry is
/// that of the ellipse's second moments. The adjugate stands for A⁻¹, so flat ellipsoids have an area, too.
/// kFullArea if the ellipsoid reaches before the near plane. Units: pixels squared. Cost: some 25 ns.
/// Source: dual conics after Hartley & Zisserman, "Multiple view geometry" (2004), section 8.3; Sadykov &
/// Zakharov,
/// *Choosing the level of detail in continuous simplification of polygonal objects* (2002), section 2.3.3,
/// names ellipsoids.
double ellipsoidAreaPx(const SelectionView& view, const Ellipsoid& ellipsoid);

} // namespace osgPMObjects::core
