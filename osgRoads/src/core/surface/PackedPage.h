// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// Vertices that follow each other, in rows across a road.
struct VertexRows
{
    std::uint32_t count = 0, columns = 1;
};

/// Returns vertices in about a quarter of their bytes: each number is a difference to what the rows before it
/// let expect, which is mostly nothing. No bit is lost. `rows`: all the vertices.
std::string packedVertices(std::span<const MeshVertex> vertices, std::span<const VertexRows> rows);

/// False: packedVertices() did not make the bytes of so many vertices. `vertices` is replaced.
bool unpackVertices(std::string_view bytes, std::uint64_t count, std::vector<MeshVertex>& vertices);

/// Returns indices in about an eighth of their bytes: rows of quads as their first vertex, their step from
/// row to row and their number, and what is no quad index by index. No bit is lost.
std::string packedIndices(std::span<const std::uint32_t> indices);

/// False: packedIndices() did not make the bytes of so many indices. `indices` is replaced; they may lie
/// beyond all vertices.
bool unpackIndices(std::string_view bytes, std::uint64_t count, std::vector<std::uint32_t>& indices);

} // namespace osgRoads::core
