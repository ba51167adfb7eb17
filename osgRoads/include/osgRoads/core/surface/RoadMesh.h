// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace osgRoads::core
{

/// What a strip of the drawn surface is made of.
enum class SurfaceKind : std::uint8_t
{
    asphalt,
    concrete,
    shoulder,
    kerb,
    sidewalk,
    gravel,
    grass,
    verge, ///< beside the outermost lanes
    skirt, ///< below the verge's outer edge, into the ground
};

/// Whether a strip looks as the ground around the road does.
inline bool isGround(SurfaceKind kind)
{
    return kind >= SurfaceKind::grass;
}

/// A vertex of the drawn surface.
/// Positions are whole steps of kMeshStepM from RoadMesh::origin: their difference to an eye is exact at any
/// distance from the scene's origin.
struct MeshVertex
{
    std::array<std::int32_t, 3> position{};
    float s = 0.0F;      ///< metres from the start of the chunk
    float across = 0.0F; ///< metres from the right border of the strip; of verges from the lanes
    float width = 0.0F;  ///< of the strip here, metres
    std::array<std::int8_t, 4>
        normal{}; ///< unit vector times 127; how far the surface has worn off, 0 to 127
    SurfaceKind kind = SurfaceKind::asphalt;
    std::uint8_t present =
        255; ///< 0: another road's carriageway covers this place; interpolated, cut at a half
    std::uint8_t rightMarks = 255; ///< 0: the mark at the right border is not painted here
    std::uint8_t leftMarks = 255;
    std::uint32_t rightRow = 0, leftRow = 0; ///< into RoadMesh::marks; 0: no mark
    std::uint32_t decalRow = 0;              ///< into RoadMesh::decals; 0: nothing else is painted
};

/// A line of a mark along a border. Units: metres.
struct MarkRowLine
{
    float offset = 0.0F;                         ///< of its middle from the border, positive to the left
    float width = 0.0F;                          ///< 0: there is no line
    float dash = 0.0F;                           ///< visible length; 0: without gaps
    float period = 0.0F;                         ///< dash and gap
    float phase = 0.0F;                          ///< of the pattern at the start of the chunk
    float red = 0.0F, green = 0.0F, blue = 0.0F; ///< linear
};

/// What is painted along one border within one chunk: at most two lines.
using MarkRow = std::array<MarkRowLine, 2>;

/// A row of RoadMesh::decals. The first of a list: its origin from the mesh's in steps of 64 m (x, y) and the
/// number of rows that follow.
/// Each of these is a Decal: start (from the list's origin) and direction in the plan view; length, half of
/// both widths, shift; dash, period, phase, 0; paint, 0. Units: metres.
using DecalRow = std::array<float, 16>;

/// One level of a chunk: a range of RoadMesh::indices, and its greatest distance from the exact surface.
struct ChunkLevel
{
    std::uint32_t firstIndex = 0, indexCount = 0;
    double errorM = 0.0;
    std::uint32_t pavedCount =
        0; ///< so many of the first indices are those of strips that are not isGround()
};

/// A stretch of a road within one lane section. Its first and last cross-sections belong to every level, so
/// that neighbouring chunks meet whatever their levels are.
struct RoadChunk
{
    int road = -1;
    double sStart = 0.0, sEnd = 0.0;
    glm::dvec3 centre{0.0}; ///< of the sphere around it, in the scene
    double radius = 0.0;
    std::uint32_t firstVertex = 0, vertexCount = 0; ///< its own, and no other's
    std::vector<ChunkLevel> levels;                 ///< the finest first; errors do not fall
};

/// The drawn surface of a network, in one pair of buffers. It never changes.
struct RoadMesh
{
    static constexpr double kMeshStepM = 1.0 / 1024.0;
    static constexpr double kReachM =
        2e6; ///< from the origin in each direction: nothing beyond is in the mesh

    glm::dvec3 origin{0.0};
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices; ///< triangles, counter-clockwise from above
    std::vector<RoadChunk> chunks;
    std::vector<MarkRow> marks;   ///< the first is empty
    std::vector<int> unreached;   ///< roads of which something lies beyond kReachM, growing
    std::vector<DecalRow> decals; ///< lists of what is painted on a strip of a chunk; the first row is empty

    /// Returns the place of a vertex in the scene. Error: half a step in each coordinate.
    glm::dvec3 placeOf(const MeshVertex& vertex) const
    {
        return origin + kMeshStepM * glm::dvec3(vertex.position[0], vertex.position[1], vertex.position[2]);
    }
};

} // namespace osgRoads::core
