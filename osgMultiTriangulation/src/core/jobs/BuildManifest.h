// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/jobs/JobOrder.h>
#include <osgMultiTriangulation/core/split/Partition.h>
#include <osgMultiTriangulation/core/surface/PlanFrame.h>

namespace osgMultiTriangulation::core
{

/// All that the jobs of a build have in common.
struct BuildManifest
{
    PlanFrame frame;
    double heightStep = 0.0;
    std::uint64_t points = 0, triangles = 0; ///< of the surface
    std::uint64_t mostHidden = 0;            ///< as in StoredBuild
    std::uint32_t identity = 0;              ///< of the build
    Partition partition;
    std::vector<std::uint64_t> trianglesOf; ///< by part: of which it is the smallest holder
};

/// Returns a manifest as a text: a line of each job, by its number, with the jobs that it needs, and a sum at
/// the end.
std::string textOf(const BuildManifest& manifest);

/// Reads what textOf() wrote. Errors: damage, another version.
foundation::Result<BuildManifest> readManifest(const std::filesystem::path& file);

} // namespace osgMultiTriangulation::core
