// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/file/MtInfo.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>

namespace osgMultiTriangulation::core
{

/// Builds a split multi-triangulation into a file. Trees do not stay in memory: each is written to the folder FILE.parts when it is
/// built, together with what is left of its part, and from there into the file. A build that was stopped or killed
/// goes on with what is whole there, and its file has the same bytes. The folder is removed in the end.
/// `mesh`: checkInput() finds nothing. Errors: stopped by `options.progress`; no such folder, no permission, no room.
foundation::Result<ForestReport> buildMtFile(const SurfaceMesh& mesh, const PlanFrame& frame,
                                             const ForestOptions& options, const std::filesystem::path& file);

} // namespace osgMultiTriangulation::core
