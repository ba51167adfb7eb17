// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/selection/BoundingVolumes.h>
#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

/// Computes the area of a sphere projected onto the image plane, also outside the image; exact. With the
/// depth c_z of the centre, its distance d from the eye and the projection P:
///     area = π |det P| r² √(d² - r²) / (c_z² - r²)^(3/2).
/// This is ellipsoidAreaPx() with equal half axes. Off the image's centre it is larger than π (K r / d)².
/// kFullArea if the sphere reaches before the near plane. Units: pixels squared. Cost: some 10 ns.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 2.3.3, names spheres; the formula is that of EllipsoidArea.h.
double sphereAreaPx(const SelectionView& view, const BoundingSphere& sphere);

} // namespace osgPMObjects::core
