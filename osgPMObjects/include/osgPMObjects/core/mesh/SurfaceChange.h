// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// How far two surfaces are apart, both ways. Units: as the positions.
struct SurfaceChange
{
    double largest = 0.0;
    double mean = 0.0; ///< over points spread by area, those of both sides together
    std::size_t samples = 0;
};

/// Measures at every corner and centre of every face that is not degenerate (kDegenerateHeight), and at points
/// spread by area, the distance to the other surface. A surface with faces and one without are infinitely far apart.
/// Cost: about a microsecond a sample; parallel.
/// Source: Aspert, Santa-Cruz and Ebrahimi, "MESH: measuring errors between surfaces using the Hausdorff distance" (2002); samples at
/// corners and centres, which are where faces come and go, besides those by area.
SurfaceChange surfaceChange(const MeasuredSurface& a, const MeasuredSurface& b);

/// The same with `spread` points a side.
SurfaceChange surfaceChange(const Mesh& a, const Mesh& b, std::size_t spread = 60000);

} // namespace osgPMObjects::core
