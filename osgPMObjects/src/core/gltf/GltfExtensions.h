// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include <osgPMObjects/core/gltf/GltfImport.h>

namespace osgPMObjects::core
{

/// Prepares the bytes of a .gltf or .glb for the parser. Extensions that the model requires are checked by
/// name; those that are left out go into `report`. What the format allows and the parser does not is
/// rewritten: buffers that only stand for decompressed data get a byte, and accessors of indices without a
/// buffer view a view of no bytes (accessorIndices() takes such a view for zeros).
/// Errors: another version than 2; a size or place of data below 0; an extension is required that is not
/// read, or has the vertices. Bytes that are no glTF are left as they are.
/// Source: Khronos, *glTF 2.0 specification* (2021), sections 3.6.2.3 (sparse accessors), 3.12 (extensions).
foundation::Outcome prepareExtensions(std::string& bytes, const std::string& name, GltfReport& report);

} // namespace osgPMObjects::core
