// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// The distance between two surfaces, in both directions. Units: as the positions.
struct SurfaceChange
{
    double largest = 0.0;
    double mean = 0.0; ///< over points spread by area on both surfaces
    std::size_t samples = 0;
};

/// Measures the distance from each surface to the other, at every corner and centre of faces that are not degenerate
/// (kDegenerateHeight), and at points spread by area. It is infinite when only one of the two has faces.
/// Cost: about a microsecond a sample; parallel.
/// Source: Aspert, Santa-Cruz and Ebrahimi, *MESH: measuring errors between surfaces using the Hausdorff distance* (2002). Differs:
/// samples also at corners and centres of faces, where simplification changes the surface.
SurfaceChange surfaceChange(const MeasuredSurface& a, const MeasuredSurface& b);

/// The same with `spread` points on each surface.
SurfaceChange surfaceChange(const Mesh& a, const Mesh& b, std::size_t spread = 60000);

} // namespace osgPMObjects::core
