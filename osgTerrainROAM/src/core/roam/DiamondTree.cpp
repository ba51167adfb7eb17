// SPDX-License-Identifier: Apache-2.0
// ROAM's triangle bintree: split, forced split and the merge of diamonds after Duchaineau et al. 1997, §4.
// Differences: what is stored are the vertices with the diamonds around them, not the triangles; two diamonds that share
// an edge hang on the same corner, in neighbouring quadrants, so that neighbours are found with two steps.
#include <algorithm>
#include <cassert>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

namespace
{

/// The eight directions, counter-clockwise from east.
constexpr int kColumnStep[8] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int kRowStep[8] = {0, 1, 1, 1, 0, -1, -1, -1};

constexpr unsigned next(unsigned quadrant)
{
    return (quadrant + 1u) & 3u;
}

constexpr unsigned previous(unsigned quadrant)
{
    return (quadrant + 3u) & 3u;
}

/// Which of the corners 0 and 2, those that are parents, is an end of the outer edge of a quadrant.
constexpr unsigned parentOnEdge(unsigned quadrant)
{
    return (quadrant + 1u) & 2u;
}

} // namespace

DiamondTree::DiamondTree(std::shared_ptr<const RoamTile> tile)
    : _tile(std::move(tile)),
      _levels(_tile->tile.levels()),
      _regionLevel(_tile->regions.level()),
      _dataFillsTile(std::min(_tile->tile.dataColumns(), _tile->tile.dataRows()) == _tile->tile.side()),
      _leaves(_tile->regions.regionCount() + 1),
      _undrawnLeaves(_tile->regions.regionCount() + 1)
{
    // The corners as if they had split something larger: the apexes of the two roots have one quadrant each.
    const auto [first, second] = rootTriangles(_tile->tile.side());
    const GridPoint corners[kCorners] = {first.apex, second.apex, first.left, first.right};
    for (const GridPoint p : corners)
    {
        const VertexSlot slot = takeSlot();
        _places[slot] = {static_cast<std::uint16_t>(p.column), static_cast<std::uint16_t>(p.row), -1, 0, {}};
    }
    _places[0].direction = 2;
    _places[1].direction = 6;
    for (const TriangleId root : kRoots)
        addLeaf(root);
}

VertexSlot DiamondTree::takeSlot()
{
    VertexSlot slot;
    if (_freeSlots.empty())
    {
        slot = vertexSlots();
        appendTightly(_places);
        appendTightly(_diamonds);
    }
    else
    {
        slot = _freeSlots.back();
        _freeSlots.pop_back();
    }
    _changes.vertices.push_back(slot);
    return slot;
}

/// From the apex towards the middle of the base, as far as that times `scale` / 4, in quarters of samples.
GridPoint DiamondTree::towardsMiddle(TriangleId t, int scale) const
{
    const DiamondPlace& apex = _places[t.apex()];
    const unsigned direction = (apex.direction + 2u * t.quadrant() + 1u) & 7u;
    const int height = (scale * (_tile->tile.side() - 1)) >> ((apex.level + 3) / 2);
    return {4 * apex.column + kColumnStep[direction] * height, 4 * apex.row + kRowStep[direction] * height};
}

GridPoint DiamondTree::middle(TriangleId t) const
{
    const GridPoint quarters = towardsMiddle(t, 4);
    return {quarters.column / 4, quarters.row / 4};
}

VertexSlot DiamondTree::addVertex(TriangleId t, TriangleId partner)
{
    const VertexSlot v = takeSlot(); // may move the pools: no reference is taken before
    const DiamondPlace& apex = _places[t.apex()];
    const GridPoint p = middle(t);
    DiamondPlace& place = _places[v];
    place.column = static_cast<std::uint16_t>(p.column);
    place.row = static_cast<std::uint16_t>(p.row);
    place.level = static_cast<std::int8_t>(apex.level + 1);
    place.direction =
        static_cast<std::uint8_t>((apex.direction + 2u * t.quadrant() + 5u) & 7u); // back to the apex
    place.parentQuadrants[0] = static_cast<std::uint8_t>(t.quadrant());
    place.parentQuadrants[1] = static_cast<std::uint8_t>(partner.exists() ? partner.quadrant() : 0u);
    const std::uint32_t beyond = partner.exists() ? kUndrawn : kAbsent;
    _diamonds[v] = {{t.apex(), partner.exists() ? partner.apex() : kNone},
                    {kUndrawn, beyond, beyond, kUndrawn}};
    return v;
}

void DiamondTree::removeVertex(VertexSlot v)
{
    _places[v].direction |= DiamondPlace::kFree;
    _freeSlots.push_back(v);
}

GridTriangle DiamondTree::gridTriangle(TriangleId t) const
{
    const DiamondPlace& apex = _places[t.apex()];
    const int leg = (_tile->tile.side() - 1) >> ((apex.level + 2) / 2);
    const auto cornerAt = [&](unsigned index)
    {
        const unsigned direction = (apex.direction + 2u * index) & 7u;
        return GridPoint{apex.column + kColumnStep[direction] * leg, apex.row + kRowStep[direction] * leg};
    };
    return {apex.point(), cornerAt(t.quadrant()), cornerAt(t.quadrant() + 1u)};
}

/// Corners 1 and 3 are those of the first parent's quadrant that the vertex has split.
VertexSlot DiamondTree::corner(VertexSlot v, unsigned index) const
{
    if (v < kCorners) return 2u + ((v + index) & 1u); // the roots' bases
    if (index % 2 == 0) return _diamonds[v].parents[index / 2];
    const unsigned quadrant = _places[v].parentQuadrants[0];
    return corner(_diamonds[v].parents[0], index == 1 ? quadrant : next(quadrant));
}

LeafTriangle DiamondTree::vertices(TriangleId t) const
{
    return {{t.apex(), corner(t.apex(), t.quadrant()), corner(t.apex(), next(t.quadrant()))}};
}

MeshVertex DiamondTree::vertex(VertexSlot v) const
{
    const DiamondPlace& at = _places[v];
    const glm::dvec3 position = _tile->tile.position(at.column, at.row);
    const glm::vec3 high(position);
    return {high, glm::vec3(position - glm::dvec3(high)), glm::vec2(at.column, at.row)};
}

std::array<TriangleId, 2> DiamondTree::children(TriangleId t) const
{
    const VertexSlot v = splitVertex(t);
    const unsigned slot = _diamonds[v].parents[0] == t.apex() ? 0u : 2u;
    return {TriangleId(v, slot), TriangleId(v, previous(slot))};
}

std::array<TriangleId, 2> DiamondTree::parents(VertexSlot v) const
{
    const Diamond& diamond = _diamonds[v];
    const auto& quadrants = _places[v].parentQuadrants;
    return {TriangleId(diamond.parents[0], quadrants[0]),
            diamond.parents[1] == kNone ? TriangleId() : TriangleId(diamond.parents[1], quadrants[1])};
}

TriangleId DiamondTree::acrossBase(TriangleId t) const
{
    if (t.apex() < kCorners) return kRoots[t == kRoots[0] ? 1 : 0];
    // The base ends at one of the diamond's parents. What lies across hangs on that parent, too, one quadrant further.
    const unsigned slot = parentOnEdge(t.quadrant());
    const VertexSlot parent = _diamonds[t.apex()].parents[slot / 2];
    const unsigned mine = _places[t.apex()].parentQuadrants[slot / 2];
    const bool clockwise = t.quadrant() % 2 == 0;
    const TriangleId coarser(parent, clockwise ? previous(mine) : next(mine));
    if (!exists(coarser)) return {};
    if (isLeaf(coarser)) return coarser;
    const VertexSlot v = splitVertex(coarser);
    const unsigned back = _diamonds[v].parents[0] == parent ? 0u : 2u;
    return {v, clockwise ? previous(back) : back};
}

TriangleId DiamondTree::acrossLeg(TriangleId t, bool right) const
{
    const TriangleId beside(t.apex(), right ? next(t.quadrant()) : previous(t.quadrant()));
    if (!exists(beside) || isLeaf(beside)) return exists(beside) ? beside : TriangleId();
    return children(beside)[right ? 0 : 1];
}

bool DiamondTree::isInData(TriangleId t) const
{
    if (_dataFillsTile) return true;
    const GridTriangle g = gridTriangle(t);
    return std::min({g.apex.column, g.left.column, g.right.column}) < _tile->tile.dataColumns() - 1 &&
           std::min({g.apex.row, g.left.row, g.right.row}) < _tile->tile.dataRows() - 1;
}

std::uint32_t DiamondTree::regionOf(TriangleId t) const
{
    if (level(t) < _regionLevel) return 0;
    return 1 + _tile->regions.pathAt(towardsMiddle(t, 2)); // half-way to the base: inside, on no border
}

void DiamondTree::relink(TriangleRange slots)
{
    for (std::uint32_t slot = slots.first; slot < slots.first + slots.count; ++slot)
        link(_leaves.leaf(slot)) = slot;
}

void DiamondTree::addLeaf(TriangleId t)
{
    ++_leafCount;
    const std::uint32_t region = regionOf(t);
    if (isInData(t)) return relink(_leaves.insert(t, region, _changes));
    link(t) = kUndrawn;
    ++_undrawnLeaves[region];
}

void DiamondTree::removeLeaf(TriangleId t)
{
    --_leafCount;
    const std::uint32_t region = regionOf(t);
    if (link(t) != kUndrawn)
        relink(_leaves.erase(link(t), region, _changes));
    else
        --_undrawnLeaves[region];
}

/// Makes `t` split by `v`, whose two quadrants in it become leaves. The first takes over the slot of `t` where it can.
void DiamondTree::splitLeaf(TriangleId t, VertexSlot v)
{
    const std::uint32_t slot = link(t);
    const bool staysInRegion = slot != kUndrawn && level(t) >= _regionLevel;
    if (!staysInRegion) removeLeaf(t);
    link(t) = kSplit | v;
    const auto [first, second] = children(t);
    if (staysInRegion && isInData(first))
    {
        _leaves.replace(slot, first, _changes);
        link(first) = slot;
        addLeaf(second);
        return;
    }
    if (staysInRegion)
    {
        --_leafCount;
        relink(_leaves.erase(slot, regionOf(first), _changes));
    }
    addLeaf(first);
    addLeaf(second);
}

/// Makes `t`, whose halves are leaves, one again. It takes over the slot of the first.
void DiamondTree::mergeLeaves(TriangleId t)
{
    const auto [first, second] = children(t);
    removeLeaf(second);
    const std::uint32_t slot = link(first);
    if (slot != kUndrawn && level(t) >= _regionLevel)
    {
        _leaves.replace(slot, t, _changes);
        link(t) = slot;
        return;
    }
    removeLeaf(first);
    addLeaf(t);
}

std::uint32_t DiamondTree::forceSplit(TriangleId t)
{
    assert(canSplit(t));
    std::uint32_t splits = 0;
    TriangleId partner = acrossBase(t);
    if (partner.exists() && level(partner) < level(t))
    {
        splits += forceSplit(partner);
        partner = acrossBase(t);
    }
    const VertexSlot v = addVertex(t, partner);
    splitLeaf(t, v);
    if (!partner.exists()) return splits + 1;
    splitLeaf(partner, v);
    return splits + 2;
}

std::uint32_t DiamondTree::splitsNeeded(TriangleId t) const
{
    std::uint32_t splits = 0;
    for (TriangleId partner;; t = partner)
    {
        partner = acrossBase(t);
        splits += partner.exists() ? 2 : 1;
        if (!partner.exists() || level(partner) == level(t)) return splits;
    }
}

bool DiamondTree::isMergeable(VertexSlot v) const
{
    const auto& links = _diamonds[v].links;
    return v >= kCorners && !_places[v].isFree() &&
           std::none_of(std::begin(links), std::end(links),
                        [](std::uint32_t l) { return l >= kSplit && l != kAbsent; });
}

void DiamondTree::merge(VertexSlot v)
{
    assert(isMergeable(v));
    for (const TriangleId t : parents(v))
        if (t.exists()) mergeLeaves(t);
    removeVertex(v);
}

std::uint32_t DiamondTree::forceMerge(VertexSlot v)
{
    std::uint32_t merges = 0;
    for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
        if (const TriangleId t(v, quadrant); exists(t) && !isLeaf(t)) merges += forceMerge(splitVertex(t));
    const bool atBorder = !parents(v)[1].exists();
    merge(v);
    return merges + (atBorder ? 1u : 2u);
}

std::size_t DiamondTree::memoryBytes() const
{
    return _places.capacity() * sizeof(DiamondPlace) + _diamonds.capacity() * sizeof(Diamond) +
           _freeSlots.capacity() * sizeof(VertexSlot) + _collapsing.capacity() * sizeof(TriangleId) +
           _leaves.memoryBytes() + _undrawnLeaves.capacity() * sizeof(std::uint32_t) +
           (_changes.vertices.capacity() + _changes.triangles.capacity()) * sizeof(std::uint32_t);
}

} // namespace osgTerrainROAM::core
