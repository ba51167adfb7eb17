// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Returns how different each material looks from the most similar one of larger area: the largest difference
/// of a colour's channels by a quarter, 0 to 1. It is 1 for the material of the largest area, and for all
/// where colours are unknown; transparent and opaque materials have nothing in common.
/// `colours`: by material, or fewer; `areas`: by material, in any unit. Cost: quadratic in the materials.
std::vector<double> materialContrasts(std::span<const Material> materials, std::span<const glm::vec3> colours,
                                      std::span<const double> areas);

} // namespace osgPMObjects::core
