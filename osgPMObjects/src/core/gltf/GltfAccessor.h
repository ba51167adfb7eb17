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

/// Reads the values of an accessor as doubles; missing components are (0, 0, 0, 1), normalised integers are
/// scaled. Empty when the accessor is sparse, or the accessor, its view or its buffer is shorter than
/// declared.
std::optional<std::vector<glm::dvec4>> accessorValues(const tinygltf::Model& model, int accessor);

/// Reads the values of an accessor of indices; empty under the same conditions.
std::optional<std::vector<std::uint32_t>> accessorIndices(const tinygltf::Model& model, int accessor);

} // namespace osgPMObjects::core
