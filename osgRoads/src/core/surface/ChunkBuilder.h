// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ChunkRows.h"
#include "ChunkStrips.h"
#include "ChunkTriangles.h"
#include "ChunkVertices.h"

namespace osgRoads::core
{

/// Adds the chunks of one lane section to a mesh.
class ChunkBuilder
{
public:
    ChunkBuilder(const PlacedNetwork& network, int road, const LaneSection& section, const OpenEnds& ends,
                 const RoadMeshSettings& settings, MarkRows& marks, DecalRows& decals, RoadMesh& mesh);

    void add(double from, double to);

private:
    bool isWithinReach() const;
    RoadChunk chunkOf(double from, double to, std::uint32_t firstVertex) const;

    const PlacedNetwork& _network;
    int _road;
    CrossSection _shape;
    JunctionCover _cover;
    RoadMesh& _mesh;
    ChunkRows _rows;
    ChunkStrips _strips;
    ChunkVertices _vertices;
    ChunkTriangles _triangles;
};

} // namespace osgRoads::core
