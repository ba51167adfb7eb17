// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include <osgRoads/core/surface/RoadMesh.h>

#include "ChunkRows.h"
#include "OpenEnds.h"
#include "StripCut.h"

namespace osgRoads::core
{

/// What a chunk lies on or in. It lies wholly on a bridge or in a tunnel, or wholly outside.
struct ChunkPlace
{
    double from = 0.0; ///< where it begins, in metres along the road
    bool hasGround = true, isInTunnel = false;
};

/// Adds the vertices of cross-sections to a mesh, and says what of them other roads cover.
class ChunkVertices
{
public:
    ChunkVertices(const PlacedNetwork& network, int road, const LaneSection& section, const OpenEnds& ends,
                  const CrossSection& shape, const JunctionCover& cover, const ChunkRows& rows,
                  RoadMesh& mesh);

    /// Adds a row of the chunk. `strips`: what the vertices of each strip have in common (ChunkStrips).
    void addRow(std::size_t row, const ChunkPlace& place, const std::vector<MeshVertex>& strips);

private:
    /// One strip of a row, and what covers both of its borders.
    struct StripOfRow
    {
        std::size_t first = 0, count = 0; ///< columns
        bool isSkirt = false, isRightCovered = false, isLeftCovered = false;
        std::uint8_t right = 255, left = 255; ///< what is drawn at its borders
    };

    bool isOutsideOfTunnel(const Lane& lane, const ChunkRow& row) const;
    bool isCovered(const ChunkRow& row, double t, JunctionCover::By by);
    StripOfRow stripOf(std::size_t row, const Strip& strip, std::size_t first, const ChunkPlace& place);
    bool isDeckGap(const ChunkRow& row, std::size_t first, int side) const;
    void cutByOthers(std::size_t row, const Strip& strip, StripOfRow& of) const;
    void addStrip(const ChunkRow& row, const ChunkRow& other, const StripOfRow& strip, MeshVertex vertex);

    const PlacedNetwork& _network;
    int _road;
    const LaneSection& _section;
    const OpenEnds& _ends;
    const CrossSection& _shape;
    const JunctionCover& _cover;
    const ChunkRows& _rows;
    StripCut _cut;
    RoadMesh& _mesh;
    // Two strips share a border, where the answer is the same.
    double _askedT = std::numeric_limits<double>::quiet_NaN();
    JunctionCover::By _askedBy = JunctionCover::By::carriageway;
    bool _isAskedCovered = false;
};

} // namespace osgRoads::core
