// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/bake/PackCharts.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// The mesh with the atlas' texture coordinates in set 0, and white for vertex colours, for the atlas holds them. Normals stay; a
/// wedge in several charts becomes several, wedges that differed in texture or colour only become one. Faces keep
/// their order, materials have what wedges have now.
Mesh atlasMesh(const Mesh& mesh, const Atlas& atlas);

} // namespace osgPMObjects::core
