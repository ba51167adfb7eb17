// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Returns by wedge the first one at the same point with the same attributes. Where edges were split,
/// positions have copies whose wedges draw the same; a graphics card needs one vertex for all of them. Cost:
/// linear.
std::vector<std::uint32_t> firstEqualWedges(const Mesh& mesh);

} // namespace osgPMObjects::core
