// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace osgPMObjects
{

/// Returns what is subtracted from positions before they become floats: their middle, if they lie farther
/// from 0 than four times their extent, otherwise 0.
glm::dvec3 floatOrigin(std::span<const glm::dvec3> positions);

} // namespace osgPMObjects
