// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include <osgTerrainROAM/core/bisection/BisectionTree.h>

namespace osgTerrainROAM::core
{

BisectionTree::BisectionTree(const CoarseMesh& mesh, int levels)
    : _mesh(mesh), _levels(levels), _leaves(mesh.sides()), _isSplit(std::size_t{mesh.sides()} << levels)
{
    assert(levels >= 1 && levels <= 24);
}

void BisectionTree::set(Bisector t, bool isSplit)
{
    _isSplit[placeOf(t)] = isSplit;
    _leaves += isSplit ? 1u : ~0u; // one more, or one less
}

std::uint32_t BisectionTree::forceSplit(Bisector t)
{
    assert(isThere(t) && !isSplit(t) && t.level() < _levels);
    const Bisector base = neighboursOf(_mesh, t).base;
    std::uint32_t count = 1;
    if (base.exists())
    {
        if (!isThere(base)) count += forceSplit(base.parent());
        set(base, true);
        ++count;
    }
    set(t, true);
    return count;
}

std::uint32_t BisectionTree::enhMerge(Bisector t)
{
    return isSplit(t) ? removeVertex(neighboursOf(_mesh, t)) : 0;
}

std::uint32_t BisectionTree::removeVertex(const BisectorNeighbours& at)
{
    std::uint32_t count = 0;
    const auto cutBelow = [&](const BisectorNeighbours& split)
    {
        for (const unsigned which : {0u, 1u})
            if (const BisectorNeighbours half = split.half(which); isSplit(half.self))
                count += removeVertex(half);
        set(split.self, false);
        ++count;
    };
    cutBelow(at);
    if (at.base.exists()) cutBelow(neighboursOf(_mesh, at.base));
    return count;
}

bool BisectionTree::isConforming() const
{
    std::uint32_t leaves = _mesh.sides();
    for (std::uint32_t side = 0; side < _mesh.sides(); ++side)
        for (std::uint32_t node = 1; node < 1u << _levels; ++node)
        {
            const Bisector t{side, node};
            if (!isSplit(t)) continue;
            const Bisector base = neighboursOf(_mesh, t).base;
            if (!isThere(t) || (base.exists() && !isSplit(base))) return false;
            ++leaves;
        }
    return leaves == _leaves;
}

} // namespace osgTerrainROAM::core
