// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgPMObjects/core/mesh/Mesh.h>

#include "pmtool/Timing.h"

namespace pmtool
{

/// The task of a tool.
struct SimplifyTask
{
    const osgPMObjects::core::Mesh& mesh;  ///< consolidated, then equal positions welded
    const osgPMObjects::core::Mesh& shape; ///< the same, see shapeOf()
    bool seams = true; ///< whether attributes and materials are kept; otherwise only the shape counts
    std::span<const std::size_t> targets; ///< most faces of each level, falling
    double seconds = 0.0;                 ///< most time for a peer
    std::vector<glm::vec3> materialColours =
        {}; ///< of `mesh`, see osgPMObjects::materialColours(); empty: unknown
};

/// The level that a tool made for one target.
struct SimplifiedLevel
{
    osgPMObjects::core::Mesh
        mesh;        ///< materials numbered as the task's mesh; of the shape alone: one material
    double ms = 0.0; ///< elapsed; of a tool that makes all levels in one run, that run is in each
    bool isInTime = true;
};

/// A simplifier and its name. Errors of `run`: the tool refuses the mesh, or does not exist.
struct SimplifyTool
{
    std::string name;
    bool keepsSeams = true; ///< false: it gets only shapes
    std::function<foundation::Result<std::vector<SimplifiedLevel>>(const SimplifyTask&)> run;
};

/// Returns all tools that are built in.
std::vector<SimplifyTool> simplifyTools();

/// Adds the simplifiers of osgPMObjects: one for each placement, and for two of them one with accumulated
/// quadrics.
void addOwnTools(std::vector<SimplifyTool>& tools);

/// Makes levels by meshoptimizer's simplifier.
foundation::Result<std::vector<SimplifiedLevel>> meshoptimizerLevels(const SimplifyTask& task);

/// Makes levels by osgUtil::Simplifier, on one geometry for each part and material; of a shape, on one in
/// all.
foundation::Result<std::vector<SimplifiedLevel>> osgUtilLevels(const SimplifyTask& task);

/// Returns a tool that runs a separate program as `PROGRAM IN.obj FOLDER COUNT…`. The program writes
/// FOLDER/COUNT.obj for each count of faces, and a line "COUNT MS" each to its standard output. Errors: it
/// cannot be started, fails, takes too long, or writes no such file; the last line of its output is in the
/// message.
SimplifyTool peerTool(const std::string& name, const std::filesystem::path& program);

/// Returns a mesh's faces by position alone: one wedge for each position, without attributes, one material
/// and one part.
osgPMObjects::core::Mesh shapeOf(const osgPMObjects::core::Mesh& mesh);

/// Returns a mesh whose faces are these triangles of positions; degenerate ones are left out.
osgPMObjects::core::Mesh shapeOf(std::span<const glm::dvec3> positions,
                                 std::span<const std::array<std::uint32_t, 3>> triangles);

} // namespace pmtool
