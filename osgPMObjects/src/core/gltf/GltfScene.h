// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include <osgPMObjects/core/gltf/GltfImport.h>

namespace tinygltf
{
class Model;
}

namespace osgPMObjects::core
{

/// Reads the mesh of a parsed file; `into` has its materials and images already. `name` appears in messages.
foundation::Outcome readGltfScene(const tinygltf::Model& model, const std::string& name, GltfModel& into);

} // namespace osgPMObjects::core
