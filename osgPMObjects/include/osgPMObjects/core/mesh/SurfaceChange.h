// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// How far two surfaces are apart, both ways. Units: as the positions.
struct SurfaceChange
{
    double largest = 0.0;
    double mean = 0.0; ///< over points spread by area
    std::size_t samples = 0;
};

/// Measures at every corner and centre of every face that is not degenerate (kDegenerateHeight), and at `spread` points a side
/// spread by area, the distance to the other surface. A surface with faces and one without are infinitely far apart.
/// Cost: some microseconds a sample; parallel.
/// Source: Aspert, Santa-Cruz and Ebrahimi, "MESH: measuring errors between surfaces using the Hausdorff distance" (2002); samples at
/// corners and centres, which are where faces come and go, besides those by area.
SurfaceChange surfaceChange(const Mesh& a, const Mesh& b, std::size_t spread = 60000);

} // namespace osgPMObjects::core
