// SPDX-License-Identifier: Apache-2.0
#include "ChunkTriangles.h"

#include <algorithm>

namespace osgRoads::core
{

namespace
{

/// Half a step in each coordinate.
constexpr double kMeshRoundingM = 0.87 * RoadMesh::kMeshStepM;

} // namespace

/// Adds both triangles of a piece of which something is drawn.
void ChunkTriangles::addQuad(const std::array<std::uint32_t, 4>& corners)
{
    const auto isDrawn = [this](std::uint32_t corner) { return _mesh.vertices[corner].present > 0; };
    if (std::none_of(corners.begin(), corners.end(), isDrawn)) return;
    for (const std::size_t corner : {0, 1, 2, 2, 1, 3})
        _mesh.indices.push_back(corners[corner]);
}

/// Adds the triangles of one level, those of the ground's strips or those of the others.
void ChunkTriangles::addStrips(std::uint32_t firstVertex, std::size_t rows, std::size_t stride, bool ofGround)
{
    const auto columns = static_cast<std::uint32_t>(_shape.columns());
    const auto ahead = static_cast<std::uint32_t>(stride) * columns;
    for (std::size_t i = 0; i + stride < rows; i += stride)
    {
        auto right = firstVertex + static_cast<std::uint32_t>(i) * columns;
        for (const Strip& strip : _shape.strips())
        {
            const auto count = static_cast<std::uint32_t>(strip.columns);
            for (std::uint32_t j = right;
                 j + 1 < right + count && isGround(_mesh.vertices[right].kind) == ofGround; ++j)
                addQuad({j, j + ahead, j + 1, j + ahead + 1});
            right += count;
        }
    }
}

void ChunkTriangles::addLevels(RoadChunk& chunk)
{
    const std::size_t rows = (_rows.rows().size() + 1) / 2;
    double error = 0.0;
    for (std::size_t stride = 1; stride < rows; stride *= 2)
    {
        ChunkLevel level;
        level.firstIndex = static_cast<std::uint32_t>(_mesh.indices.size());
        addStrips(chunk.firstVertex, rows, stride, false);
        level.pavedCount = static_cast<std::uint32_t>(_mesh.indices.size()) - level.firstIndex;
        addStrips(chunk.firstVertex, rows, stride, true);
        level.indexCount = static_cast<std::uint32_t>(_mesh.indices.size()) - level.firstIndex;
        for (std::size_t row = 0; row < _rows.rows().size(); ++row)
            error = std::max(error, _rows.gapAt(row, 2 * stride));
        level.errorM = kBetweenSamples * error + kMeshRoundingM;
        chunk.levels.push_back(level);
    }
}

} // namespace osgRoads::core
