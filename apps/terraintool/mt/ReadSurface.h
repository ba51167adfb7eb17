// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>
#include <osgMultiTriangulation/core/surface/GridSurface.h>
#include <osgMultiTriangulation/core/surface/PlanFrame.h>
#include <osgTerrainROAM/core/heightfield/GridPlace.h>

#include "terraintool/mt/MtRequest.h"

namespace terraintool
{

/// A surface with the place of its lattice.
struct PlacedSurface
{
    osgMultiTriangulation::core::SurfaceMesh mesh;
    osgMultiTriangulation::core::PlanFrame frame;
};

/// The frame of the lattice of a raster: metres from its south-western sample, and its georeference.
osgMultiTriangulation::core::PlanFrame frameOf(double spacingEastM, double spacingNorthM,
                                               const std::optional<osgTerrainROAM::core::GridPlace>& place);

/// How the cells of a raster are cut.
osgMultiTriangulation::core::CellCut cutOf(const MtBuildRequest& request, double spacingEastM,
                                           double spacingNorthM);

/// Reads the inputs into memory, and checks them.
foundation::Result<PlacedSurface> readSurface(const MtBuildRequest& request);

/// A surface in files.
struct SpooledSurface
{
    osgMultiTriangulation::core::SurfaceSpool spool;
    osgMultiTriangulation::core::PlanFrame frame;
};

/// Reads the inputs into files in a folder that is there: in streams where request.memoryMb is a limit, at
/// once where it is 0.
foundation::Result<SpooledSurface> spoolSurface(const MtBuildRequest& request,
                                                const std::filesystem::path& folder);

} // namespace terraintool
