// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// The distance of one surface from another. Units: as the positions.
struct SurfaceDistance
{
    double largest = 0.0;
    double mean = 0.0, rootMeanSquare = 0.0; ///< over points spread by area
    std::size_t spreadSamples =
        0; ///< of these points; fewer are measured where most triangles cross the mesh
};

/// Measures the distance of the samples of one surface from another: at every corner and centre of faces that
/// are not degenerate (kDegenerateHeight), and at points spread by area. It is infinite if only the first has
/// faces.
/// Deterministic: the same for any number of threads. Cost: about a microsecond a spread point, less for the
/// others, which need not be measured below the largest distance so far; parallel.
/// Source: Cignoni, Rocchini and Scopigno, *Metro: measuring error on simplified surfaces* (1998). Differs:
/// samples also at corners and centres of faces.
SurfaceDistance surfaceDistance(const MeasuredSurface& from, const MeasuredSurface& to);

/// Searches the point of a surface that is farthest from another: climbs, inside a triangle, from the
/// farthest of each few dozen spread points, at most 256 times. Returns its distance, at least `atLeast`: the
/// largest distance of samples (surfaceDistance()), which are some per cent short where triangles are large.
/// Starts that are much nearer are left out.
/// Deterministic: the same for any number of threads. Cost: some 60 queries a start; parallel.
double farthestDistance(const MeasuredSurface& from, const MeasuredSurface& to, double atLeast);

/// The distance between two surfaces, in both directions. Units: as the positions.
struct SurfaceChange
{
    double largest = 0.0;
    double mean = 0.0; ///< over points spread by area on both surfaces
    std::size_t samples = 0;
};

/// Measures the distance from each surface to the other by surfaceDistance(). It is infinite when only one of
/// the two has faces.
/// Source: Aspert, Santa-Cruz and Ebrahimi, *MESH: measuring errors between surfaces using the Hausdorff
/// distance* (2002). Differs: samples also at corners and centres of faces, where simplification changes the
/// surface.
SurfaceChange surfaceChange(const MeasuredSurface& a, const MeasuredSurface& b);

/// The same with `spread` points on each surface.
SurfaceChange surfaceChange(const Mesh& a, const Mesh& b, std::size_t spread = 60000);

} // namespace osgPMObjects::core
