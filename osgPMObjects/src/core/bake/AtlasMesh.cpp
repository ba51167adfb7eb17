// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/bake/AtlasMesh.h>
#include <osgPMObjects/core/mesh/WedgeHash.h>

namespace osgPMObjects::core
{

Mesh atlasMesh(const Mesh& mesh, const Atlas& atlas)
{
    Mesh textured;
    textured.positions = mesh.positions;
    textured.faces = mesh.faces;
    textured.materials = mesh.materials;
    textured.parts = mesh.parts;
    for (Material& material : textured.materials)
        material.attributes =
            (material.attributes & Material::normal) | Material::texCoord0 | Material::colour;
    HashIndex known(mesh.wedgeCount());
    const auto hashOf = [&](std::uint32_t number) { return hashWedge(wedgeOf(textured, number)); };
    for (std::uint32_t f = 0; f < textured.faces.size(); ++f)
        for (std::uint32_t& number : textured.faces[f].wedges)
        {
            Wedge wedge = wedgeOf(mesh, number);
            const glm::dvec2 texel = atlas.texelOf(f, mesh.positions[wedge.position]);
            wedge.texCoords = {glm::vec2(texel / static_cast<double>(atlas.sizePx)), glm::vec2(0.0f)};
            wedge.colour = glm::vec4(1.0f);
            number = known.findOrAdd(
                static_cast<std::uint32_t>(textured.wedgeCount()), hashWedge(wedge),
                [&](std::uint32_t other) { return wedgeOf(textured, other) == wedge; }, hashOf);
            if (number == textured.wedgeCount()) appendWedge(textured, wedge);
        }
    return textured;
}

} // namespace osgPMObjects::core
