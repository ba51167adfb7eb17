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
/// scaled. The values that a sparse accessor lists replace those of its view, or zeros where it has none.
/// Empty when the accessor, its views or their buffers are shorter than declared, or a sparse value has no
/// place.
std::optional<std::vector<glm::dvec4>> accessorValues(const tinygltf::Model& model, int number);

/// Reads the values of an accessor of indices; empty under the same conditions, and without data.
std::optional<std::vector<std::uint32_t>> accessorIndices(const tinygltf::Model& model, int number);

/// Tells whether an accessor has values in the file. Without them all are zero, or an extension has them.
bool hasData(const tinygltf::Model& model, int number);

} // namespace osgPMObjects::core
