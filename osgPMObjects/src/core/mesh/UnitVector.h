// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// The unit vector in the direction of `v`, or 0 where `v` is 0.
inline glm::dvec3 unitOr0(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3(0.0);
}

} // namespace osgPMObjects::core
