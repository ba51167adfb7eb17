// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a glTF, binary or text: they become a whole mesh, which consolidation leaves
// whole, or are refused.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/gltf/GltfImport.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace osgPMObjects::core;
    const std::span<const unsigned char> bytes(data, size);
    const bool isBinary = size > 0 && data[0] == 'g';
    auto model = isBinary ? parseGlb(bytes, "fuzz.glb") : parseGltf(bytes, "fuzz.gltf");
    if (!model) return model.error().place.starts_with("fuzz.gl") ? 0 : (std::abort(), 0);
    if (!isValid(model->mesh)) std::abort();
    consolidate(model->mesh);
    if (!isValid(model->mesh)) std::abort();
    return 0;
}
