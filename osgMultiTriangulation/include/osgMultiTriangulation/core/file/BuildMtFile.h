// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/file/MtInfo.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>
#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>

namespace osgMultiTriangulation::core
{

/// Builds a split multi-triangulation into a file. Trees do not stay in memory: each is written to the folder
/// FILE.parts when it is built, together with what is left of its part, and from there into the file. A build
/// that was stopped or killed goes on with what is whole there, and its file has the same bytes. The folder
/// is removed in the end.
/// `mesh`: checkInput() finds nothing. Errors: stopped by `options.progress`; no such folder, no permission,
/// no room.
foundation::Result<ForestReport> buildMtFile(const SurfaceMesh& mesh, const PlanFrame& frame,
                                             const ForestOptions& options, const std::filesystem::path& file);

/// The same from a surface in files, within a limit of memory. Parts are so small that one fits, and of the
/// points hidden below a part only some are in memory: those choose what goes next, and the errors are
/// measured again over all of them, which are read from files. So bounds are exact; the order of removal is a
/// little worse than without a limit.
/// `limitMb`: of the whole process, which must not hold more than some MB besides. Threads are as many as
/// fit. The same limit gives the same bytes, whatever the threads; where no part has more hidden points than
/// fit, those without a limit.
/// Errors: as above; a limit that is too small, with the least that would do.
foundation::Result<ForestReport> buildMtFile(const SurfaceSpool& spool, const PlanFrame& frame,
                                             const ForestOptions& options, double limitMb,
                                             const std::filesystem::path& file);

} // namespace osgMultiTriangulation::core
