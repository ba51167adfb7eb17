// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// What the refinement predicate needs of every split vertex when each leaf carries a patch of 2^k triangles: the leaf's
/// own descendants k levels further down. So the bintree ends k levels earlier, and an error is that of the patches.
/// e_v is the largest of the tile's errors k levels below the two triangles that v splits, nested over the tree that is
/// left. Radii are the tile's: they hold everything below, patches included. k = 0: the tile's own bounds, and nothing
/// is stored.
/// k is even: then a patch divides all edges of its leaf into 2^(k/2), and neighbours of any size meet; with odd k legs
/// and bases are divided differently and do not.
/// Threads: immutable; copies share everything. Memory: 4 B for each 2^k samples. Cost of making: about 30 ns a sample.
/// Source: spec 1 D, "The four weaknesses" (a leaf can carry a patch); terrain anchors, point 5.
class SplitBounds
{
public:
    static constexpr int kMostExponent = 10;

    /// `patchExponent` is brought to an even number from 0 to kMostExponent that the tile has levels for; to 0 where the
    /// tile's grid is finer than its raster.
    SplitBounds(std::shared_ptr<const RoamTile> tile, int patchExponent = 0);

    SplitBound bound(GridPoint v) const
    {
        SplitBound bound = _tile->bound(v);
        if (_errorsM) bound.errorM = patchErrorM(v);
        return bound;
    }

    /// e_v alone: without the vertex's place, which costs more than the rest.
    float errorM(GridPoint v) const { return _errorsM ? patchErrorM(v) : _tile->errorM(v); }

    /// Tells the processor that bound(v) will be asked for.
    void prefetch(GridPoint v) const
    {
        _tile->prefetch(v);
        if (_errorsM) __builtin_prefetch(&(*_errorsM)[patchIndex(v)]);
    }

    /// The same after the tile has been edited: with patches, all is measured anew.
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
