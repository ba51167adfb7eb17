// SPDX-License-Identifier: Apache-2.0
#include "ChunkStrips.h"

namespace osgRoads::core
{

namespace
{

/// Whether a surface is painted on.
bool isPaved(SurfaceKind kind)
{
    return kind == SurfaceKind::asphalt || kind == SurfaceKind::concrete || kind == SurfaceKind::shoulder;
}

} // namespace

/// Returns the pieces of a strip between the rows of the finest level.
std::vector<SurfaceQuad> ChunkStrips::quadsOf(std::size_t firstColumn, std::size_t columns) const
{
    std::vector<SurfaceQuad> quads;
    const std::size_t last = firstColumn + columns - 1;
    for (std::size_t i = 0; i + 2 < _rows.rows().size(); i += 2)
        quads.push_back({_rows.rows()[i].places[firstColumn], _rows.rows()[i + 2].places[firstColumn],
                         _rows.rows()[i + 2].places[last], _rows.rows()[i].places[last]});
    return quads;
}

/// Whether most of a verge, of which a column is the outer edge, is a gap within a junction.
bool ChunkStrips::isGap(std::size_t column, int side) const
{
    constexpr std::size_t kAsked = 5; // rows
    std::size_t gaps = 0;
    for (std::size_t i = 0; i < kAsked; ++i)
    {
        const ChunkRow& row = _rows.rows()[i * (_rows.rows().size() - 1) / (kAsked - 1)];
        gaps += _cover.isGap(row.s, row.points[column].t, side) ? 1 : 0;
    }
    return 2 * gaps > kAsked;
}

std::vector<MeshVertex> ChunkStrips::stripsAt(double from, bool hasGround) const
{
    std::vector<MeshVertex> strips;
    const bool mayHaveGaps = _rows.mayBeCovered() && _cover.canCoverMarks() && !_cover.hasOwnPaving(from);
    std::size_t first = 0;
    for (const Strip& strip : _shape.strips())
    {
        const auto columns = static_cast<std::size_t>(strip.columns);
        MeshVertex vertex;
        const bool isOnDeck = strip.lane && isGround(strip.kind) && !hasGround;
        vertex.kind = isOnDeck ? SurfaceKind::shoulder : strip.kind; // no grass on bridges and in tunnels
        if (isPaved(vertex.kind)) vertex.decalRow = _decals.listFor(quadsOf(first, columns));
        // Nobody leaves wedges of grass between the lanes of a junction.
        const bool isRight = first < 4, isVerge = strip.isBesideLanes() && strip.kind != SurfaceKind::skirt;
        const bool isGapOfPaving =
            isVerge && mayHaveGaps && isGap(isRight ? first : first + 1, isRight ? -1 : 1);
        if (isGapOfPaving || (isVerge && !hasGround)) vertex.kind = SurfaceKind::asphalt;
        first += columns;
        if (strip.rightMark) vertex.rightRow = _marks.rowOf(_section, *strip.rightMark, from);
        if (strip.leftMark) vertex.leftRow = _marks.rowOf(_section, *strip.leftMark, from);
        strips.push_back(vertex);
    }
    return strips;
}

} // namespace osgRoads::core
