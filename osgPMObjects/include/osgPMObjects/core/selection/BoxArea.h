// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgPMObjects/core/selection/BoundingVolumes.h>
#include <osgPMObjects/core/selection/SelectionView.h>

namespace osgPMObjects::core
{

/// Where an eye is about a box, as an index of kBoxOutlines. On a face's plane it does not see the face.
std::uint32_t regionOf(const OrientedBox& box, const glm::dvec3& eyeWorld);

/// What an oriented box covers of the picture plane, inside the picture or not. Exact for the perspective projection.
/// kFullArea with a corner before the near plane, or with the eye inside.
/// Units: pixels squared. Cost: 8 corners at most 6 of which are projected, one look-up; some 50 ns.
/// Source: Schmalstieg & Tobler (1999), paper 004 section 2.3.3 and its reference 26.
double boxAreaPx(const SelectionView& view, const OrientedBox& box);

} // namespace osgPMObjects::core
