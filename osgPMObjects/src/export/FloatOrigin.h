// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace osgPMObjects
{

/// What to take off positions before they become floats: their middle where they lie farther from 0 than four times their
/// extent, and 0, so that they stay as they are, elsewhere.
glm::dvec3 floatOrigin(std::span<const glm::dvec3> positions);

} // namespace osgPMObjects
