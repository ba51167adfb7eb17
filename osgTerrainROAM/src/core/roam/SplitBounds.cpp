// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include <osgTerrainROAM/core/roam/SplitBounds.h>

#include "BottomUp.h"

namespace osgTerrainROAM::core
{

namespace
{

/// Finds the errors of patches in one descent of the bintree.
class PatchErrors
{
public:
    PatchErrors(const RoamTile& tile, int shift)
        : _tile(tile),
          _shift(shift),
          _depth(static_cast<std::size_t>(2 * shift)),
          _side(((tile.tile.grid().side() - 1) >> shift) + 1),
          _errorsM(static_cast<std::size_t>(_side) * static_cast<std::size_t>(_side), 0.0f)
    {
    }

    std::vector<float> take() &&
    {
        for (const GridTriangle& root : rootTriangles(_tile.tile.grid().side()))
            visit(root, 0);
        nest();
        return std::move(_errorsM);
    }

private:
    /// Returns the largest error of the vertices that split a triangle's descendants 0, 1, … levels below it.
    using ByDepth = std::array<float, SplitBounds::kMostExponent + 1>;

    float& error(GridPoint v) { return _errorsM[static_cast<std::size_t>(v.row) * _side + v.column]; }

    ByDepth visit(const GridTriangle& t, int level)
    {
        ByDepth largest{};
        if (level == _tile.tile.grid().levels()) return largest;
        const auto halves = t.children();
        const ByDepth first = visit(halves[0], level + 1), second = visit(halves[1], level + 1);
        largest[0] = _tile.bound(t.middleOfBase()).errorM;
        for (std::size_t depth = 1; depth <= _depth; ++depth)
            largest[depth] = std::max(first[depth - 1], second[depth - 1]);
        if (level < _tile.tile.grid().levels() - static_cast<int>(_depth))
        {
            const GridPoint v = t.middleOfBase();
            float& kept = error({v.column >> _shift, v.row >> _shift});
            kept = std::max(kept, largest[_depth]);
        }
        return largest;
    }

    void nest()
    {
        forEachDiamondBottomUp(_side,
                               [this](GridPoint v, const GridPoint* children, int count)
                               {
                                   for (int i = 0; i < count; ++i)
                                       error(v) = std::max(error(v), error(children[i]));
                               });
    }

    const RoamTile& _tile;
    const int _shift;
    const std::size_t _depth;
    const int _side;
    std::vector<float> _errorsM;
};

} // namespace

SplitBounds::SplitBounds(std::shared_ptr<const RoamTile> tile, int patchExponent)
    : _tile(std::move(tile)),
      _shift(_tile->tile.grid().exponent() > 0 || _tile->tile.samples().hasHoles()
                 ? 0
                 : std::clamp(patchExponent, 0, std::min(kMostExponent, _tile->tile.grid().levels())) / 2),
      _side(((_tile->tile.grid().side() - 1) >> _shift) + 1)
{
    if (_shift > 0) _errorsM = std::make_shared<const std::vector<float>>(PatchErrors(*_tile, _shift).take());
}

} // namespace osgTerrainROAM::core
