// SPDX-License-Identifier: Apache-2.0
#include "SurfaceColours.h"

#include <algorithm>

#include <glm/common.hpp>

#include <osg/Material>
#include <osg/TexMat>

namespace osgPMObjects
{

namespace
{

using core::Material;

glm::vec4 glmOf(const osg::Vec4& v)
{
    return {v.r(), v.g(), v.b(), v.a()};
}

/// By channel; where there is nothing to divide by, `otherwise`.
glm::vec3 ratio(const glm::vec3& part, const glm::vec3& whole, float otherwise)
{
    glm::vec3 r;
    for (int c = 0; c < 3; ++c)
        r[c] = whole[c] > 0.0f ? part[c] / whole[c] : otherwise;
    return r;
}

void divideByBase(Finish& finish, float alpha)
{
    finish.base = glm::vec4(
        glm::max(glm::max(finish.ambient, finish.diffuse), glm::max(finish.emission, finish.specular)),
        alpha);
    for (glm::vec3* part : {&finish.ambient, &finish.diffuse, &finish.emission, &finish.specular})
        *part = ratio(*part, finish.base, 0.0f);
}

bool isEnabled(const osg::StateSet& state, unsigned unit)
{
    const auto mode = state.getTextureMode(unit, GL_TEXTURE_2D);
    return mode != osg::StateAttribute::INHERIT && (mode & osg::StateAttribute::ON) != 0;
}

} // namespace

Finish finishOf(const osg::StateSet& state, const VertexColours& colours)
{
    const bool hasColours = colours.have;
    using Mode = osg::Material::ColorMode;
    constexpr auto kFront = osg::Material::FRONT;
    static const osg::ref_ptr<const osg::Material> nothingSet = new osg::Material;
    const auto* set = dynamic_cast<const osg::Material*>(state.getAttribute(osg::StateAttribute::MATERIAL));
    const osg::Material& material = set ? *set : *nothingSet;
    // What OSG begins with: faces follow their colours, and those that have none are light grey, darker in ambient light.
    const Mode mode = set          ? set->getColorMode()
                      : hasColours ? osg::Material::AMBIENT_AND_DIFFUSE
                                   : osg::Material::OFF;
    Finish finish;
    const auto lighting = state.getMode(GL_LIGHTING);
    finish.isLit = lighting == osg::StateAttribute::INHERIT || (lighting & osg::StateAttribute::ON) != 0;
    const bool isFollowing = hasColours && (mode == osg::Material::DIFFUSE ||
                                            mode == osg::Material::AMBIENT_AND_DIFFUSE || !finish.isLit);
    finish.timesColours = isFollowing && colours.differ;
    // An osg::Material makes its diffuse colour the current one, which is what faces without colours of their own have.
    const glm::vec4 diffuse = finish.timesColours                    ? glm::vec4(1.0f)
                              : isFollowing                          ? colours.first
                              : finish.isLit || (set && !hasColours) ? glmOf(material.getDiffuse(kFront))
                                                                     : glm::vec4(1.0f);
    finish.diffuse = glm::vec3(diffuse);
    if (finish.isLit)
    {
        finish.ambient = mode == osg::Material::AMBIENT_AND_DIFFUSE
                             ? finish.diffuse
                             : glm::vec3(glmOf(material.getAmbient(kFront)));
        finish.emission = glm::vec3(glmOf(material.getEmission(kFront)));
        finish.specular = glm::vec3(glmOf(material.getSpecular(kFront)));
        finish.shininess = material.getShininess(kFront);
    }
    divideByBase(finish, diffuse.a);
    return finish;
}

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
    // Another material divides what it takes of diffuse light, so that both show the same in it.
    const glm::vec3 share = ratio(finish.diffuse, _finishes[shownWith].diffuse, 1.0f);
    return glm::clamp(colour * glm::vec4(share, 1.0f), 0.0f, 1.0f);
}

} // namespace osgPMObjects
