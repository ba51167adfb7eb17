// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgPMObjects::core
{

/// The surface that a face is drawn with. The state itself (textures, shaders, colours) stays with the
/// importer.
struct Material
{
    /// Attributes that a wedge may have besides its position.
    enum Attribute : std::uint32_t
    {
        normal = 1,
        texCoord0 = 2,
        texCoord1 = 4,
        colour = 8,
    };

    std::string name;
    std::uint32_t state = 0;      ///< the importer's handle, handed back on export
    std::uint32_t attributes = 0; ///< Attribute bits that the wedges of its faces have
    /// attribute bits that the state does not use, present or not: texture coordinates without a texture …
    std::uint32_t unseen = 0;
    bool isTwoSided = false;       ///< neither side is culled
    bool litFromBothSides = false; ///< a face seen from its back is lit with inverted normals
    bool isTransparent = false;    ///< blended: faces behind it are visible

    bool has(Attribute attribute) const { return (attributes & attribute) != 0; }
    bool operator==(const Material&) const = default;
};

/// A named object of the imported file.
struct Part
{
    std::string name;
    bool operator==(const Part&) const = default;
};

/// A triangle of wedges, counter-clockwise seen from outside.
struct Face
{
    std::array<std::uint32_t, 3> wedges{};
    std::uint32_t material = 0;
    std::uint32_t part = 0;
    bool operator==(const Face&) const = default;
};

/// A triangle mesh in plain arrays. Faces that meet at a point share its position. A *wedge* is a position
/// with the attributes that some of those faces have there; a position on a crease or a texture seam has
/// several. A wedge is a vertex of the graphics card.
/// Positions are doubles: at scene coordinates (UTM, Earth-centred) floats have a resolution of half a metre,
/// and welding, predicates and quadrics need the digits. This costs 6 B a triangle. Attributes are floats.
/// Frame: right-handed, that of the imported root. Units: those of the file (metres in a trainer's models).
/// Invariant: isValid() of MeshCheck.h. Memory: 24 B a position, 4 to 48 a wedge, 20 a face; 55 MB for a
/// closed mesh of a million triangles with normals and one set of texture coordinates.
/// Source: Hoppe, *Progressive meshes* (1996), section 2 (corners); wedges: Hoppe, *Efficient implementation
/// of progressive meshes* (1998).
struct Mesh
{
    static constexpr std::size_t kTexCoordSets = 2;

    std::vector<glm::dvec3> positions;

    std::vector<std::uint32_t> wedgePositions;                   ///< by wedge
    std::vector<glm::vec3> normals;                              ///< by wedge, or empty
    std::array<std::vector<glm::vec2>, kTexCoordSets> texCoords; ///< each by wedge, or empty
    std::vector<glm::vec4> colours; ///< by wedge, or empty; red, green, blue, alpha

    std::vector<Face> faces;
    std::vector<Material> materials;
    std::vector<Part> parts;

    std::size_t wedgeCount() const { return wedgePositions.size(); }

    /// The position of a face's corner 0, 1 or 2: its number, and its coordinates.
    std::uint32_t positionOf(const Face& face, int corner) const
    {
        return wedgePositions[face.wedges[corner]];
    }
    const glm::dvec3& at(const Face& face, int corner) const { return positions[positionOf(face, corner)]; }
};

} // namespace osgPMObjects::core
