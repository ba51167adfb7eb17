// SPDX-License-Identifier: Apache-2.0
#include "PolishState.h"

namespace osgPMObjects::core
{

namespace
{

float luminanceOf(const glm::vec4& colour)
{
    return 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
}

PictureRing ringFor(const Mesh& original, const Mesh& level, std::span<const SeenMaterial> materials,
                    const PolishSettings& settings)
{
    const ImageFrame frame(original.positions);
    PictureRing ring(settings, level.faces.size());
    {
        PictureRing reference(settings, original.faces.size());
        reference.addAll(seenFaces(original, frame, materials));
        ring.setReference(reference);
    }
    ring.addAll(seenFaces(level, frame, materials));
    return ring;
}

/// Returns the weight of quadric costs: a displacement in pixels, squared, times the area displaced. The
/// small factor is since a surface displaced by a pixel is visible at its outline only, in few views.
double shapeScaleFor(const PolishSettings& settings)
{
    constexpr double kSeen = 1e-3;
    const double pixels = settings.sizePx;
    return kSeen * settings.shapeShare * pixels * pixels * pixels * pixels;
}

std::vector<glm::dvec3> unitPositions(const Mesh& level, const ImageFrame& frame)
{
    std::vector<glm::dvec3> positions;
    positions.reserve(level.positions.size());
    for (const glm::dvec3& p : level.positions)
        positions.push_back(frame.in(p));
    return positions;
}

} // namespace

std::vector<SeenMaterial> seenMaterials(const Mesh& mesh, std::span<const MaterialLook> looks)
{
    static const MaterialLook kWhite;
    std::vector<SeenMaterial> seen;
    for (std::size_t i = 0; i < mesh.materials.size(); ++i)
    {
        const Material& material = mesh.materials[i];
        seen.push_back({i < looks.size() ? &looks[i] : &kWhite, material.isTwoSided,
                        material.litFromBothSides, material.isTransparent});
    }
    return seen;
}

void setCorner(SeenFace& face, int corner, const glm::dvec3& at, const Wedge& wedge, const Material& material)
{
    face.corners[corner] = at;
    face.normals[corner] = material.has(Material::normal) ? wedge.normal : glm::vec3(0.0f);
    face.texCoords[corner] = wedge.texCoords[0];
    face.luminances[corner] =
        face.material.look->luminance * (material.has(Material::colour) ? luminanceOf(wedge.colour) : 1.0f);
}

std::vector<SeenFace> seenFaces(const Mesh& mesh, const ImageFrame& frame,
                                std::span<const SeenMaterial> materials)
{
    std::vector<SeenFace> faces(mesh.faces.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
        const Face& face = mesh.faces[f];
        faces[f].number = f;
        faces[f].material = materials[face.material];
        for (int i = 0; i < 3; ++i)
            setCorner(faces[f], i, frame.in(mesh.at(face, i)), wedgeOf(mesh, face.wedges[i]),
                      mesh.materials[face.material]);
    }
    return faces;
}

PolishState::PolishState(const Mesh& original, Mesh level, std::span<const MaterialLook> looks,
                         const PolishSettings& settings)
    : mesh(std::move(level)),
      materials(seenMaterials(mesh, looks)),
      positions(unitPositions(mesh, ImageFrame(original.positions))),
      box(extentOf(positions)),
      stars(mesh),
      errors(positions.size()),
      facesOfMaterial(mesh.materials.size(), 0),
      weight{1.0, 0.1 / static_cast<double>(std::max<std::size_t>(mesh.faces.size(), 1))},
      shapeScale(shapeScaleFor(settings)),
      ring(ringFor(original, mesh, materials, settings))
{
    for (const Face& face : mesh.faces)
        ++facesOfMaterial[face.material];
}

SeenFace PolishState::seen(std::uint32_t face) const
{
    SeenFace seen;
    seen.number = face;
    const std::uint32_t material = mesh.faces[face].material;
    seen.material = materials[material];
    for (int i = 0; i < 3; ++i)
        setCorner(seen, i, positions[stars.positions(face)[i]], wedgeOf(mesh, stars.wedges(face)[i]),
                  mesh.materials[material]);
    return seen;
}

} // namespace osgPMObjects::core
