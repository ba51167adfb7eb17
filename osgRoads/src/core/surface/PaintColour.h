// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <osgRoads/core/network/RoadMark.h>

namespace osgRoads::core
{

/// Returns the linear reflectance of the paint of road marks.
glm::vec3 paintOf(MarkColour colour);

} // namespace osgRoads::core
