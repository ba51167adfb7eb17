// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgPMObjects/core/selection/BoundingVolumes.h>
#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

/// Returns the region of space around a box that the eye is in, as an index of kBoxOutlines. An eye in the
/// plane of a face does not see that face.
std::uint32_t regionOf(const OrientedBox& box, const glm::dvec3& eyeWorld);

/// Computes the area of a box projected onto the image plane, also outside the image. Exact for a perspective
/// projection; kFullArea if a corner is before the near plane or the eye is inside the box.
/// Units: pixels squared. Cost: one table look-up and at most 6 projected corners; some 50 ns.
/// Source: Schmalstieg & Tobler, "Fast projected area computation for three-dimensional bounding boxes"
/// (1999), cited by Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of
/// polygonal objects* (2002), section 2.3.3.
double boxAreaPx(const SelectionView& view, const OrientedBox& box);

} // namespace osgPMObjects::core
