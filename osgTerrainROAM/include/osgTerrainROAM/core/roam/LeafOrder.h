// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <foundation/VertexCache.h>

#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

class TerrainMesh;

/// Measures of how well an order of triangles suits the hardware. Units: per triangle, except the strips.
struct LeafOrder
{
    double stripLength = 0.0; ///< mean number of triangles in a row that share an edge with the one before
    double stripVertices =
        0.0; ///< sent, were those rows drawn as strips: 3, then 1 each, 1 more for a turn to the same side
    double missesFifo16 = 0.0;  ///< vertices transformed, by a cache of the last 16 …
    double missesFifo32 = 0.0;  ///< … or 32 of them,
    double missesBatch32 = 0.0; ///< or of 32 triangles at a time, that share theirs
    double gaps = 0.0;          ///< triangles without extent, sent besides
};

/// Simulates draw calls on models of vertex caches and strips; each call begins with an empty cache. A
/// triangle whose corners are one vertex is a gap: it sends that vertex, but neither counts nor breaks a
/// strip.
/// Memory: 20 B per vertex. Cost: some 20 ns a triangle. Source: VertexCache.h.
class LeafOrderMeter
{
public:
    explicit LeafOrderMeter(std::uint32_t vertexCount)
        : _fifo16(vertexCount, 16), _fifo32(vertexCount, 32), _batch32(vertexCount, {.triangles = 32})
    {
    }

    void draw(std::span<const LeafTriangle> triangles);
    LeafOrder result() const;

private:
    /// The last triangle of the strip: the edge shared with the one before (older vertex first, once that is
    /// known) and its new vertex.
    struct Strip
    {
        std::uint32_t older = kNone, newer = kNone, newest = kNone;
        std::uint32_t length = 0;
    };

    void extendStrip(const LeafTriangle& triangle);
    bool continuesStrip(const LeafTriangle& triangle);

    foundation::FifoCache _fifo16, _fifo32;
    foundation::BatchCache _batch32;
    Strip _strip;
    std::uint64_t _triangles = 0, _gaps = 0, _strips = 0, _stripVertices = 0;
};

/// Measures a whole mesh as it is drawn, one call a range of slots.
LeafOrder orderOf(const TerrainMesh& mesh);

/// The same of triangles in the order in which they lie.
LeafOrder orderOf(const DrawnMesh& mesh);

} // namespace osgTerrainROAM::core
