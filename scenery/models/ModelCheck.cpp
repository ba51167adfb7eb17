// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/ModelCheck.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

namespace scenery::models
{

namespace
{

namespace core = osgPMObjects::core;

constexpr double kLeastHeightM = 1e-6; ///< of a triangle

std::string defectOfWedges(const core::Mesh& mesh)
{
    if (mesh.normals.size() != mesh.wedgeCount()) return "there are no normals";
    if (mesh.texCoords[0].size() != mesh.wedgeCount()) return "there are no texture coordinates";
    if (mesh.colours.size() != mesh.wedgeCount()) return "there are no colours";
    for (const glm::vec3& normal : mesh.normals)
        if (std::abs(glm::length(normal) - 1.0F) > 1e-3F) return "a normal is no unit vector";
    return {};
}

std::string defectOfFaces(const Model& model)
{
    const core::Mesh& mesh = model.mesh;
    if (mesh.faces.empty()) return "there are no faces";
    for (const core::Material& material : mesh.materials)
        if (material.state >= model.surfaces.size()) return "a material has no surface";
    for (const core::Face& face : mesh.faces)
        if (core::heightOf(mesh.at(face, 0), mesh.at(face, 1), mesh.at(face, 2)) < kLeastHeightM)
            return "a face of part " + mesh.parts[face.part].name + " has no area";
    return {};
}

std::string defectOfMeasures(const Model& model)
{
    double radius = 0.0, low = 0.0, high = 0.0;
    for (const glm::dvec3& p : model.mesh.positions)
    {
        radius = std::max(radius, std::hypot(p.x, p.y));
        low = std::min(low, p.z);
        high = std::max(high, p.z);
    }
    if (radius != model.radiusM || high != model.heightM || -low != model.foundationM)
        return "radius, height or foundation are not the mesh's";
    return {};
}

} // namespace

std::string defectOf(const Model& model)
{
    for (const std::string& defect : {core::defectOf(model.mesh), defectOfWedges(model.mesh)})
        if (!defect.empty()) return defect;
    const std::string defect = defectOfFaces(model);
    return defect.empty() ? defectOfMeasures(model) : defect;
}

bool isClosed(const core::Mesh& mesh, const std::string& partName)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> passes;
    for (const core::Face& face : mesh.faces)
    {
        if (mesh.parts[face.part].name != partName) continue;
        for (int c = 0; c < 3; ++c)
        {
            const std::uint32_t a = mesh.positionOf(face, c);
            const std::uint32_t b = mesh.positionOf(face, (c + 1) % 3);
            passes[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    }
    return !passes.empty() &&
           std::all_of(passes.begin(), passes.end(), [](const auto& p) { return p.second == 0; });
}

} // namespace scenery::models
