// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// The bounds of every split vertex for a mesh whose leaves carry patches of 2^k triangles: the leaf's own
/// descendants k levels further down. So the bintree ends k levels earlier, and an error is that of the
/// patches. e_v is the largest of the tile's errors k levels below the two triangles that v splits, nested
/// over the remaining tree. Radii are the tile's: they bound everything below, patches included. k = 0: the
/// tile's own bounds; nothing is stored. k is even, so a patch divides all edges of its leaf into 2^(k/2)
/// segments, and patches of neighbours of any size meet. With odd k legs and bases would be divided
/// differently.
/// Threads: immutable; copies share everything. Memory: 4 B for each 2^k samples. Cost of making: about 30 ns
/// a sample.
/// Source: Cignoni et al., *BDAM: batched dynamic adaptive meshes*, 2003 (a leaf is a patch whose edges match
/// its neighbours').
class SplitBounds
{
public:
    static constexpr int kMostExponent = 10;

    /// `patchExponent` is reduced to an even number from 0 to kMostExponent for which the tile has levels; to
    /// 0 where the tile's grid is finer than its raster.
    SplitBounds(std::shared_ptr<const RoamTile> tile, int patchExponent = 0);

    SplitBound bound(GridPoint v) const
    {
        SplitBound bound = _tile->bound(v);
        if (_errorsM) bound.errorM = patchErrorM(v);
        return bound;
    }

    /// The error e_v alone: it does not need the vertex's position, which costs more.
    float errorM(GridPoint v) const { return _errorsM ? patchErrorM(v) : _tile->errorM(v); }

    /// Prefetches the memory that bound(v) will read.
    void prefetch(GridPoint v) const
    {
        _tile->prefetch(v);
        if (_errorsM) __builtin_prefetch(&(*_errorsM)[patchIndex(v)]);
    }

    /// The bounds after an edit of the tile; with patches, all are measured anew.
    SplitBounds remade() const { return SplitBounds(_tile, patchExponent()); }

    const RoamTile& tile() const { return *_tile; }
    int patchExponent() const { return 2 * _shift; }
    int levels() const
    {
        return _tile->tile.grid().levels() - patchExponent();
    } ///< of the bintree that can split
    std::size_t memoryBytes() const { return _errorsM ? _errorsM->capacity() * sizeof(float) : 0; }

private:
    std::size_t patchIndex(GridPoint v) const
    {
        return static_cast<std::size_t>(v.row >> _shift) * static_cast<std::size_t>(_side) +
               static_cast<std::size_t>(v.column >> _shift);
    }
    float patchErrorM(GridPoint v) const { return (*_errorsM)[patchIndex(v)]; }

    std::shared_ptr<const RoamTile> _tile;
    int _shift; ///< log2 of the samples from one vertex of the finest leaves to the next
    int _side;  ///< such vertices along the tile
    std::shared_ptr<const std::vector<float>> _errorsM; ///< null without patches
};

} // namespace osgTerrainROAM::core
