// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// By wedge, the first one at the same place with the same attributes. Where edges were split, positions have copies, and wedges
/// there differ in nothing that is drawn: a graphics card needs one vertex for all of them.
/// Cost: linear.
std::vector<std::uint32_t> firstEqualWedges(const Mesh& mesh);

} // namespace osgPMObjects::core
