// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <osgRoads/core/surface/RoadMesh.h>

#include "ChunkRows.h"

namespace osgRoads::core
{

/// Adds the levels of a chunk, whose vertices are in the mesh already: each keeps every second row of the
/// level before it.
class ChunkTriangles
{
public:
    ChunkTriangles(const CrossSection& shape, const ChunkRows& rows, RoadMesh& mesh)
        : _shape(shape), _rows(rows), _mesh(mesh)
    {
    }

    void addLevels(RoadChunk& chunk);

private:
    void addQuad(const std::array<std::uint32_t, 4>& corners);
    void addStrips(std::uint32_t firstVertex, std::size_t rows, std::size_t stride, bool ofGround);

    const CrossSection& _shape;
    const ChunkRows& _rows;
    RoadMesh& _mesh;
};

} // namespace osgRoads::core
