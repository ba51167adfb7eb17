// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// From what an importer delivers to a mesh that simplify() does best with: consolidated, and what consolidation split at crowded
/// edges joined again, for simplification can do with such edges, but not with gaps. No faces may be left.
/// Cost: that of consolidate().
void makeSimplifiable(Mesh& mesh);

} // namespace osgPMObjects::core
