// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <foundation/Result.h>

namespace tinygltf
{
class Model;
}

namespace osgPMObjects::core
{

/// The names of the compression by meshoptimizer: that of the vendors, and its successor.
inline constexpr std::array<std::string_view, 2> kMeshoptExtensions{"EXT_meshopt_compression",
                                                                    "KHR_meshopt_compression"};

/// Decompresses the buffer views that are compressed by meshoptimizer; each gets a buffer of its own. `name`
/// appears in messages.
/// Errors: a view is damaged, or of a newer format than the library reads; each names the extension and the
/// view.
/// Source: Khronos, *EXT_meshopt_compression* (2020).
foundation::Outcome decompressViews(tinygltf::Model& model, const std::string& name);

} // namespace osgPMObjects::core
