// SPDX-License-Identifier: Apache-2.0
#include "SurfaceColours.h"

#include <algorithm>

#include <glm/common.hpp>

#include <osg/TexMat>

namespace osgPMObjects
{

namespace
{

using core::Material;

bool isEnabled(const osg::StateSet& state, unsigned unit)
{
    const auto mode = state.getTextureMode(unit, GL_TEXTURE_2D);
    return mode != osg::StateAttribute::INHERIT && (mode & osg::StateAttribute::ON) != 0;
}

} // namespace

SurfaceColours::SurfaceColours(const ImportedModel& full) : _full(full)
{
    const core::Mesh& mesh = full.mesh;
    std::vector<VertexColours> colours(mesh.materials.size());
    for (const core::Face& face : mesh.faces)
        for (const std::uint32_t wedge : face.wedges)
            if (mesh.materials[face.material].has(Material::colour))
                colours[face.material].add(mesh.colours[wedge]);
    for (std::size_t m = 0; m < mesh.materials.size(); ++m)
        addMaterial(mesh.materials[m], *full.states[mesh.materials[m].state], colours[m]);
}

void SurfaceColours::addMaterial(const Material& material, const osg::StateSet& state,
                                 const VertexColours& colours)
{
    _finishes.push_back(finishOf(state, colours));
    auto& pictures = _pictures.emplace_back();
    auto& matrices = _texMats.emplace_back();
    for (unsigned unit = 0; unit < kUnits; ++unit)
    {
        const auto* texture =
            dynamic_cast<const osg::Texture*>(state.getTextureAttribute(unit, osg::StateAttribute::TEXTURE));
        pictures[unit] = nullptr;
        const auto set = unit == 0 ? Material::texCoord0 : Material::texCoord1;
        if (!texture || !isEnabled(state, unit) || !material.has(set)) continue;
        auto& read = _read[texture];
        if (!read)
        {
            read = std::make_unique<TexturePicture>(*texture);
            if (!read->isRead()) ++_texturesNotRead;
        }
        pictures[unit] = read.get();
        if (const auto* matrix = dynamic_cast<const osg::TexMat*>(
                state.getTextureAttribute(unit, osg::StateAttribute::TEXMAT)))
            matrices[unit] = matrix->getMatrix();
    }
}

glm::vec4 SurfaceColours::at(std::uint32_t f, const glm::dvec3& weights, std::uint32_t shownWith) const
{
    const core::Mesh& mesh = _full.mesh;
    const core::Face& face = mesh.faces[f];
    const auto mean = [&](const auto& values)
    {
        return static_cast<float>(weights.x) * values[face.wedges[0]] +
               static_cast<float>(weights.y) * values[face.wedges[1]] +
               static_cast<float>(weights.z) * values[face.wedges[2]];
    };
    const Finish& finish = _finishes[face.material];
    glm::vec4 colour(1.0f);
    for (unsigned unit = 0; unit < kUnits; ++unit)
    {
        if (!_pictures[face.material][unit]) continue;
        const glm::vec2 place = mean(mesh.texCoords[unit]);
        const osg::Vec3d moved = osg::Vec3d(place.x, place.y, 0.0) * _texMats[face.material][unit];
        colour *= _pictures[face.material][unit]->at({moved.x(), moved.y()});
    }
    if (finish.timesColours) colour *= mean(mesh.colours);
    colour *= finish.base;
    if (face.material == shownWith) return colour;
    // Another material divides its diffuse light by its own base, so both give the same.
    const glm::vec3 share = ratio(finish.diffuse, _finishes[shownWith].diffuse, 1.0f);
    return glm::clamp(colour * glm::vec4(share, 1.0f), 0.0f, 1.0f);
}

} // namespace osgPMObjects
