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

/// The mesh of a parsed file; materials and images are in `into` already.
foundation::Outcome readGltfScene(const tinygltf::Model& model, const std::string& name, GltfModel& into);

} // namespace osgPMObjects::core
