// SPDX-License-Identifier: Apache-2.0
#include "Subjects.h"

#include <cstdio>
#include <sstream>

#include "StaticMesh.h"
#include "TerrainTechnique.h"

namespace framebench
{

namespace
{

std::string textOf(double number)
{
    std::ostringstream text;
    text << number;
    return text.str();
}

Subject ours(const Request& request, double tolerancePx, bool morphing)
{
    Subject subject;
    subject.name = "RoamDrawable " + textOf(tolerancePx) + " px" + (morphing ? ", morphing" : "");
    subject.draws = "the wheel's mesh, visible regions only; vertices in whole steps";
    subject.roam = new osgTerrainROAM::RoamDrawable(request.tile);
    const auto set = subject.roam->setSettings({.errorTolerancePx = tolerancePx, .morphing = morphing});
    if (!set) std::fprintf(stderr, "%s\n", set.error().message().c_str());
    subject.node = subject.roam;
    return subject;
}

} // namespace

std::vector<Subject> subjectsOf(const Request& request, Look look)
{
    const auto& tile = request.tile->tile;
    std::vector<Subject> subjects;
    for (const double tolerancePx : request.tolerancesPx)
        for (const bool morphing : {false, true})
            subjects.push_back(ours(request, tolerancePx, morphing));
    subjects.push_back({"full grid",
                        "every cell, one static buffer, the same vertices and program as ours",
                        fullGrid(tile, tile.grid().side()),
                        nullptr,
                        {}});
    subjects.push_back({"full grid in patches",
                        "the same in patches of 64 cells that OSG culls",
                        fullGrid(tile, kFullGridPatchCells),
                        nullptr,
                        {}});
    subjects.push_back({"GeometryTechnique",
                        "osgTerrain's defaults, sample ratio 1; our fragment shader behind a vertex shader "
                        "for its gl_Vertex",
                        terrainTechnique(tile, request.material, look),
                        nullptr,
                        {}});
    if (look == Look::relief)
        subjects.push_back({"GeometryTechnique, fixed function",
                            "osgTerrain's defaults, sample ratio 1, its own normals under OSG's light",
                            terrainTechnique(tile, nullptr, look),
                            nullptr,
                            {}});
    return subjects;
}

} // namespace framebench
