// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <glm/geometric.hpp>

#include <osg/Image>
#include <osg/Material>
#include <osg/Texture>

#include <osgPMObjects/MaterialLooks>

namespace osgPMObjects
{

namespace
{

glm::vec3 rgbOf(const osg::Vec4& colour)
{
    return {colour.r(), colour.g(), colour.b()};
}

/// The mean of at most 64 by 64 texels, each as much as it is opaque; white where there are none.
glm::vec3 meanOf(const osg::Image& picture)
{
    constexpr int kMostTexels = 64;
    if (picture.s() < 1 || picture.t() < 1 || !picture.data()) return glm::vec3(1.0f);
    const int wide = std::min(picture.s(), kMostTexels), high = std::min(picture.t(), kMostTexels);
    glm::vec3 sum(0.0f);
    float weight = 0.0f;
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x)
        {
            const osg::Vec4 colour = picture.getColor(static_cast<unsigned>(x * picture.s() / wide),
                                                      static_cast<unsigned>(y * picture.t() / high));
            sum += colour.a() * rgbOf(colour);
            weight += colour.a();
        }
    return weight > 0.0f ? sum / weight : glm::vec3(1.0f);
}

/// Returns the mean of the wedges' colours of each material, weighted by area; white where it has none.
std::vector<glm::vec3> meanWedgeColours(const core::Mesh& mesh)
{
    std::vector<glm::vec3> colours(mesh.materials.size(), glm::vec3(1.0f));
    if (mesh.colours.empty()) return colours;
    std::vector<glm::dvec4> sums(mesh.materials.size(), glm::dvec4(0.0));
    for (const core::Face& face : mesh.faces)
    {
        const double area =
            glm::length(glm::cross(mesh.at(face, 1) - mesh.at(face, 0), mesh.at(face, 2) - mesh.at(face, 0)));
        for (const std::uint32_t wedge : face.wedges)
            sums[face.material] += area * glm::dvec4(glm::dvec3(mesh.colours[wedge]), 1.0);
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (sums[i].w > 0.0) colours[i] = glm::vec3(glm::dvec3(sums[i]) / sums[i].w);
    return colours;
}

glm::vec3 diffuseOf(const osg::StateSet& state)
{
    const auto* material =
        dynamic_cast<const osg::Material*>(state.getAttribute(osg::StateAttribute::MATERIAL));
    return material ? rgbOf(material->getDiffuse(osg::Material::FRONT)) : glm::vec3(1.0f);
}

glm::vec3 textureOf(const osg::StateSet& state)
{
    const auto* texture =
        dynamic_cast<const osg::Texture*>(state.getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    const bool hasImage = texture && texture->getNumImages() > 0 && texture->getImage(0);
    return hasImage ? meanOf(*texture->getImage(0)) : glm::vec3(1.0f);
}

} // namespace

std::vector<glm::vec3> materialColours(const core::Mesh& mesh,
                                       std::span<const osg::ref_ptr<osg::StateSet>> states)
{
    std::vector<glm::vec3> colours = meanWedgeColours(mesh);
    for (std::size_t i = 0; i < colours.size(); ++i)
    {
        const core::Material& material = mesh.materials[i];
        const osg::StateSet* state = material.state < states.size() ? states[material.state].get() : nullptr;
        if (!state) continue;
        const bool showsWedges =
            material.has(core::Material::colour) && (material.unseen & core::Material::colour) == 0;
        if (!showsWedges) colours[i] = diffuseOf(*state);
        if (material.has(core::Material::texCoord0)) colours[i] *= textureOf(*state);
    }
    return colours;
}

} // namespace osgPMObjects
