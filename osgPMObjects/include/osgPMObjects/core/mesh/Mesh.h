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

/// What surface a face is drawn with. The state itself (textures, shaders, colours) stays with whoever imported it.
struct Material
{
    /// What wedges can have besides their position.
    enum Attribute : std::uint32_t
    {
        normal = 1,
        texCoord0 = 2,
        texCoord1 = 4,
        colour = 8,
    };

    std::string name;
    std::uint32_t state = 0;      ///< the importer's handle, handed back on export
    std::uint32_t attributes = 0; ///< Attribute bits: what its faces' wedges have
    std::uint32_t unseen =
        0; ///< what the state does not look at, had or not: texture coordinates without a texture …
    bool isTwoSided = false;       ///< neither side is culled
    bool litFromBothSides = false; ///< a face seen from its back is lit by its normals turned round
    bool isTransparent = false;    ///< blended: faces behind it count

    bool has(Attribute attribute) const { return (attributes & attribute) != 0; }
    bool operator==(const Material&) const = default;
};

/// What was one thing in the file, by name.
struct Part
{
    std::string name;
    bool operator==(const Part&) const = default;
};

/// Three wedges, counter-clockwise seen from outside.
struct Face
{
    std::array<std::uint32_t, 3> wedges{};
    std::uint32_t material = 0;
    std::uint32_t part = 0;
    bool operator==(const Face&) const = default;
};

/// A triangle mesh of plain arrays. Positions are shared by all faces that meet there; a *wedge* is a position with the
/// attributes that some of those faces see there, so a position on a crease or on a seam of the texture has several. A wedge
/// is a vertex of the graphics card.
/// Positions are doubles: placements in a scene (UTM, Earth-centred) leave floats half a metre, and welding, predicates and
/// quadrics need the digits; 12 B more a position are 6 B a triangle. Attributes are floats, as they are drawn.
/// Frame: right-handed, the root's of what was imported. Units: the file's (metres in a trainer's models).
/// Invariant: isValid() of MeshCheck.h. Memory: 24 B a position, 4 to 48 a wedge, 20 a face: a closed mesh of a million
/// triangles with normals and one set of texture coordinates 55 MB.
/// Source: Hoppe, "Progressive meshes" (1996), §2 (corners); "wedge" is his later name.
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

    /// The position of a face's corner 0, 1 or 2: its number, and where it is.
    std::uint32_t positionOf(const Face& face, int corner) const
    {
        return wedgePositions[face.wedges[corner]];
    }
    const glm::dvec3& at(const Face& face, int corner) const { return positions[positionOf(face, corner)]; }
};

} // namespace osgPMObjects::core
