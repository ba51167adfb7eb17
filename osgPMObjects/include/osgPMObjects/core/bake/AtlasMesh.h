// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/bake/PackCharts.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Returns the mesh with the atlas' texture coordinates in set 0, and white vertex colours, since the atlas
/// holds the colours. Normals are kept. A wedge in several charts becomes several; wedges that differed in
/// texture or colour only become one. Faces keep their order; Material::attributes are those of the new
/// wedges.
Mesh atlasMesh(const Mesh& mesh, const Atlas& atlas);

} // namespace osgPMObjects::core
