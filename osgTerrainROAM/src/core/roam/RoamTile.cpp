// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

RoamTile::RoamTile(PlacedTile placedTile) : tile(std::move(placedTile)), regions(tile), hidingGround(tile)
{
    const ErrorTree measured(tile);
    const auto side = static_cast<SampleIndex>(tile.side());
    for (int row = 0; row < tile.side(); ++row)
        for (int column = 0; column < tile.side(); ++column)
        {
            const SampleIndex v = static_cast<SampleIndex>(row) * side + static_cast<SampleIndex>(column);
            if (tile.isInData(column, row))
                tile.samples().setBound(tile.sampleIndex(column, row), measured.errorM(v),
                                        measured.radiusM(v));
            else if (measured.errorM(v) > 0.0f)
                _beyond[v] = {measured.errorM(v), measured.radiusM(v)};
        }
}

SplitBound RoamTile::boundBeyond(GridPoint v) const
{
    const auto found = _beyond.find(static_cast<SampleIndex>(v.row) * static_cast<SampleIndex>(tile.side()) +
                                    static_cast<SampleIndex>(v.column));
    const Bound bound = found == _beyond.end() ? Bound{0.0f, 0.0f} : found->second;
    return {glm::vec3(tile.position(v.column, v.row)), bound.errorM, bound.radiusM};
}

} // namespace osgTerrainROAM::core
