// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <osgMultiTriangulation/core/file/MtInfo.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>
#include <osgPMObjects/core/tessellate/QuadDiagonal.h>
#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "terminal/Report.h"

namespace terraintool
{

/// What the command line of mt-build asks for.
struct MtBuildRequest
{
    std::vector<std::filesystem::path> inputs;
    std::filesystem::path output;
    osgTerrainROAM::core::DemImportOptions import;
    osgMultiTriangulation::core::ForestOptions options;
    double memoryMb = 0.0;                                      ///< 0: no limit
    std::optional<osgPMObjects::core::DiagonalRule> diagonal{}; ///< of the cells of rasters; absent: heights
};

/// What the command lines of mt-job and mt-join ask for.
struct MtJobRequest
{
    std::filesystem::path folder;    ///< of mt-plan
    std::vector<std::uint64_t> jobs; ///< of mt-job
    std::filesystem::path output;    ///< of mt-join
};

/// What the command line of mt-fly asks for.
struct MtFlyRequest
{
    std::filesystem::path file;
    double speedMps = 100.0, aboveM = 100.0, seconds = 60.0;
    double memoryMb = 64.0;      ///< that trees may take
    double megabytesPerS = 50.0; ///< reading is slowed down to this; 0: it is not
    double tolerancePx = 2.0;
    int widthPx = 1280; ///< of the picture, which is 60 degrees wide
};

/// Flies over a .mt file in real time, 60 frames a second, without drawing: measures how long frames wait,
/// and checks surfaces for holes.
foundation::Result<terminal::Report> flyMt(const MtFlyRequest& request);

/// Builds a split multi-triangulation from elevation rasters, from files of points (.csv, .xyz, .txt), or
/// from a file of triangles (.obj, .ply, .terrain).
foundation::Result<terminal::Report> buildMt(const MtBuildRequest& request);

/// The same within request.memoryMb of memory: the surface is read in streams, and built from files beside
/// the output.
foundation::Result<terminal::Report> buildMtWithin(const MtBuildRequest& request);

/// Cuts a build into jobs, in the folder request.output, and prints which of them may be done at once.
foundation::Result<terminal::Report> planMt(const MtBuildRequest& request);

/// Reads the inputs and plans the build in a folder.
foundation::Outcome planInto(const MtBuildRequest& request, const std::filesystem::path& folder);

/// Does some jobs of a plan, one after the other.
foundation::Result<terminal::Report> doMtJobs(const MtJobRequest& request);

/// Writes the .mt file of a plan whose jobs are done.
foundation::Result<terminal::Report> joinMt(const MtJobRequest& request);

/// Whether a file has points as text: .csv, .xyz, .txt.
bool isPointFile(const std::filesystem::path& file);

/// Tells inputs of different kinds, more than one file of triangles, and what is wrong with their heads,
/// before any is read.
foundation::Outcome checkInputs(const MtBuildRequest& request);

/// Tells by how much places have been moved, where that is more than a thousandth of a step.
void tellRounding(double mostMoved, const osgMultiTriangulation::core::PlanFrame& frame);

/// The most resident memory that this process has had, MB.
double peakMb();

/// Checks a .mt file: every tree by itself, how they hang together, and a flight over all that is whole.
/// Adds a row of a table to `report`, and prints it.
void validateMt(const std::filesystem::path& file, int frames, terminal::Report& report);

} // namespace terraintool
