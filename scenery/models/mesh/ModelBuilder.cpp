// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/mesh/ModelBuilder.h"

#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/consolidate/MergeWedges.h>
#include <osgPMObjects/core/consolidate/Normals.h>

#include "scenery/models/mesh/MeasureModel.h"

namespace scenery::models
{

namespace
{

namespace core = osgPMObjects::core;

glm::dvec3 rounded(const glm::dvec3& p)
{
    constexpr double kSteps = 4096.0;
    const auto near = [](double v) { return std::round(v * kSteps) / kSteps + 0.0; }; // + 0 turns -0 into 0
    return {near(p.x), near(p.y), near(p.z)};
}

} // namespace

void ModelBuilder::begin(const std::string& part, const Surface& surface, const glm::vec3& tint)
{
    const auto known = std::find(_surfaces.begin(), _surfaces.end(), surface);
    core::Material material;
    material.state = static_cast<std::uint32_t>(known - _surfaces.begin());
    if (known == _surfaces.end()) _surfaces.push_back(surface);
    material.name = "surface " + std::to_string(material.state);
    material.attributes = core::Material::normal | core::Material::texCoord0 | core::Material::colour;
    material.isTwoSided = surface.coat == Coat::foliage;
    _material = _mesh.material(material);
    _part = _mesh.part(part);
    _tint = tint;
}

void ModelBuilder::triangle(const Corner& a, const Corner& b, const Corner& c)
{
    const std::array<const Corner*, 3> corners{&a, &b, &c};
    std::array<std::uint32_t, 3> positions{};
    for (std::size_t i = 0; i < 3; ++i)
        positions[i] = _mesh.position(rounded(_turn * corners[i]->at + _shift));
    if (positions[0] == positions[1] || positions[1] == positions[2] || positions[2] == positions[0]) return;
    core::Face face;
    face.material = _material;
    face.part = _part;
    for (std::size_t i = 0; i < 3; ++i)
    {
        core::Wedge wedge;
        wedge.position = positions[i];
        wedge.normal = glm::mat3(_turn) * corners[i]->normal;
        wedge.texCoords[0] = corners[i]->uv;
        wedge.colour = glm::vec4(_tint * corners[i]->light, 1.0F);
        face.wedges[i] = _mesh.wedge(wedge);
    }
    _mesh.face(face);
}

void ModelBuilder::quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d)
{
    triangle(a, b, c);
    triangle(a, c, d);
}

void ModelBuilder::grid(const std::vector<std::vector<Corner>>& rows)
{
    for (std::size_t r = 0; r + 1 < rows.size(); ++r)
        for (std::size_t i = 0; i + 1 < rows[r].size(); ++i)
            quad(rows[r][i], rows[r][i + 1], rows[r + 1][i + 1], rows[r + 1][i]);
}

Model ModelBuilder::finish(double creaseDeg)
{
    Model model;
    model.mesh = _mesh.finish();
    core::Smoothing smoothing;
    smoothing.creaseAngleDeg = creaseDeg;
    core::computeNormals(model.mesh, smoothing);
    core::mergeWedges(model.mesh);
    core::compactMesh(model.mesh);
    model.surfaces = std::move(_surfaces);
    measureModel(model);
    return model;
}

} // namespace scenery::models
