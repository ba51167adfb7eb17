// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgTerrainROAM/core/vdpm/BoundedForest.h>

namespace osgTerrainROAM::core
{

/// Prepares any manifold mesh, closed or with border, as a view-dependent progressive mesh: collapses of
/// osgPMObjects' simplify() (quadrics), the forest, bounds that are measured, and cones of normals. Samples
/// are the positions and the middles of the faces. Each belongs to one face of every mesh: after a collapse,
/// to the nearest of the faces that took its face's place. The error of a face is the largest distance of its
/// samples. So where a split is not wanted, each sample is as near to the surface that is drawn as its bound
/// says. A cone holds the normals of the faces that a split changes, and of the faces of the mesh at all
/// samples in them: where it is turned away, neither the samples nor what is drawn for them is seen.
/// Errors: a mesh with no face, or an edge of more than two faces. Frame and units: those of the mesh. Cost:
/// that of simplify(), and about 10 µs a position. Memory: about 600 B a position while it works.
foundation::Result<BoundedForest> surfaceForest(const osgPMObjects::core::Mesh& mesh);

} // namespace osgTerrainROAM::core
