// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Prepares an imported mesh for simplify(): consolidates it, then joins again what consolidation split at
/// non-manifold edges, since simplification handles such edges but not gaps. The result may have no faces.
/// Cost: that of consolidate().
void makeSimplifiable(Mesh& mesh);

} // namespace osgPMObjects::core
