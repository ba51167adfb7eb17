// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace tinygltf
{
class Model;
}

namespace osgPMObjects::core
{

/// The values of an accessor as doubles; missing components are (0, 0, 0, 1), normalised integers are scaled. Nothing where the
/// accessor, its view or its buffer does not hold what it says, or is sparse.
std::optional<std::vector<glm::dvec4>> accessorValues(const tinygltf::Model& model, int accessor);

/// The values of an accessor of indices.
std::optional<std::vector<std::uint32_t>> accessorIndices(const tinygltf::Model& model, int accessor);

} // namespace osgPMObjects::core
