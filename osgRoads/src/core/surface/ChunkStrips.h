// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/surface/RoadMesh.h>

#include "ChunkRows.h"
#include "DecalRows.h"
#include "MarkRows.h"

namespace osgRoads::core
{

/// Finds what the vertices of each strip of a chunk have in common: what the strip is made of, and what is
/// painted on it.
class ChunkStrips
{
public:
    ChunkStrips(const LaneSection& section, const CrossSection& shape, const JunctionCover& cover,
                const ChunkRows& rows, MarkRows& marks, DecalRows& decals)
        : _section(section), _shape(shape), _cover(cover), _rows(rows), _marks(marks), _decals(decals)
    {
    }

    /// Returns a vertex for each strip of a chunk that begins at `from`, in metres along the road.
    std::vector<MeshVertex> stripsAt(double from, bool hasGround) const;

private:
    bool isGap(std::size_t column, int side) const;
    std::vector<SurfaceQuad> quadsOf(std::size_t firstColumn, std::size_t columns) const;

    const LaneSection& _section;
    const CrossSection& _shape;
    const JunctionCover& _cover;
    const ChunkRows& _rows;
    MarkRows& _marks;
    DecalRows& _decals;
};

} // namespace osgRoads::core
