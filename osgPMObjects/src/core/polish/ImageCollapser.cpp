// SPDX-License-Identifier: Apache-2.0
#include "ImageCollapser.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "../simplify/patch/PatchCheck.h"
#include "../simplify/patch/RecordCollapse.h"
#include "../simplify/sequence/LevelErrors.h"

namespace osgPMObjects::core
{

namespace
{

/// The most neighbours of a position that are evaluated: those of the least quadric cost.
constexpr std::size_t kMostRankedTried = 24;

} // namespace

CollapseSequence ImageCollapser::run(std::size_t targetFaces)
{
    _done.facesBefore = _facesLeft = _state.stars.faceCount();
    for (std::uint32_t p = 0; p < _state.positions.size() && _facesLeft > targetFaces; ++p)
        enter(p);
    while (_facesLeft > targetFaces && !_queue.isEmpty())
    {
        const std::uint32_t first = _queue.first();
        if (_isStale[first])
            enter(first);
        else
            collapse(first);
    }
    return std::move(_done);
}

StarShape ImageCollapser::shapeOf(const Star& star) const
{
    const auto isBorder = [&](std::span<const Star::Side> sides)
    {
        const auto materialOf = [&](const Star::Side& side)
        { return _state.mesh.faces[star.faces[side.spoked].face].material; };
        return std::any_of(sides.begin(), sides.end(),
                           [&](const Star::Side& side)
                           { return materialOf(side) != materialOf(sides.front()); });
    };
    return starShape(star, _state.positions, _state.weight, isBorder);
}

/// Returns the position of the edge from `_star.middle` after its collapse, and its quadric cost.
ImageCollapser::Place ImageCollapser::placeFor(std::uint32_t to)
{
    const glm::dvec3 &here = _state.positions[_star.middle], &there = _state.positions[to];
    if (!_movesPlaces) return {there, std::max(0.0, _shape.quadric.at(there - here))};
    _toStar.gather(_state.stars, _state.positions, to);
    const StarShape toShape = shapeOf(_toStar);
    const CollapsingEdge edge{here, there, _shape, toShape, sharedAreaVector(_star, to)};
    const glm::dvec3 at = glm::clamp(bestPlace(edge), _state.box.low, _state.box.high);
    return {at, costAt(edge, at)};
}

/// Sorts the neighbours that a position may merge into by cost.
void ImageCollapser::rank(std::uint32_t position)
{
    _star.gather(_state.stars, _state.positions, position);
    _shape = shapeOf(_star);
    _ranked.clear();
    for (const std::uint32_t to : _star.neighbours)
        _ranked.push_back({to, placeFor(to).cost});
    std::sort(_ranked.begin(), _ranked.end(),
              [](const Ranked& a, const Ranked& b)
              { return a.shapeCost != b.shapeCost ? a.shapeCost < b.shapeCost : a.to < b.to; });
    if (_ranked.size() > kMostRankedTried) _ranked.resize(kMostRankedTried);
}

void ImageCollapser::enter(std::uint32_t position)
{
    rank(position);
    _isStale[position] = false;
    _best[position] = ~0u;
    Urgency least;
    int tried = 0;
    for (const Ranked& ranked : _ranked)
    {
        const Urgency urgency = urgencyOf(ranked);
        if (_best[position] == ~0u || urgency < least) least = urgency, _best[position] = ranked.to;
        if (!urgency.doesHarm && ++tried >= _settings.choices) break;
    }
    if (_best[position] == ~0u)
        _queue.erase(position);
    else
        _queue.set(position, least);
}

Urgency ImageCollapser::urgencyOf(const Ranked& ranked)
{
    plan(ranked.to);
    const double shape = _state.shapeScale * ranked.shapeCost;
    if (isHarmful(ranked.to, _at)) return {true, shape};
    return {false, _state.ring.change(_removed, _added) + shape};
}

bool ImageCollapser::isHarmful(std::uint32_t to, const glm::dvec3& at) const
{
    if (foldsOver({_star, _state.positions, to, at})) return true;
    if (_movesPlaces && foldsOver({_toStar, _state.positions, _star.middle, at})) return true;
    for (const Star::Side& side : _star.sidesTo(to))
    {
        const std::uint32_t material = _state.mesh.faces[_star.faces[side.spoked].face].material;
        if (_state.facesOfMaterial[material] <= _star.sidesTo(to).size()) return true;
    }
    return false;
}

/// Returns the attributes of a wedge of either position after the planned step.
Wedge ImageCollapser::wedgeAfter(std::uint32_t wedge, bool isOfFrom) const
{
    std::uint32_t becomes = wedge;
    if (isOfFrom)
        for (const WedgeChange& change : _plan.ofFrom())
        {
            if (change.wedge != wedge) continue;
            if (change.becomes == wedge) return change.attributes;
            becomes = change.becomes;
        }
    Wedge after = wedgeOf(_state.mesh, becomes);
    for (const WedgeChange& change : _plan.ofTo())
        if (change.becomes == becomes) after = change.attributes;
    return after;
}

/// Adds the faces of a star before the planned step, and the remaining ones after it.
void ImageCollapser::addPatch(const Star& star, std::uint32_t besides)
{
    const bool isOfFrom = star.middle == _star.middle;
    for (const Star::Spoked& spoked : star.faces)
    {
        if (!isOfFrom && spoked.has(besides)) continue; // has been added already
        _removed.push_back(_state.seen(spoked.face));
        if (spoked.has(besides)) continue;
        _added.push_back(_removed.back());
        const Triangle& p = _state.stars.positions(spoked.face);
        const int corner = p[0] == star.middle ? 0 : p[1] == star.middle ? 1 : 2;
        setCorner(_added.back(), corner, _at, wedgeAfter(spoked.wedge, isOfFrom),
                  _state.mesh.materials[_state.mesh.faces[spoked.face].material]);
    }
}

/// Plans the collapse of `_star.middle` into a neighbour.
void ImageCollapser::plan(std::uint32_t to)
{
    const WedgedMesh wedged{_state.stars, _state.mesh, _state.positions};
    _at = placeFor(to).at;
    if (_movesPlaces)
        _plan.resample(wedged, _star, _toStar, _at);
    else
        _plan.match(wedged, _star, to);
    _removed.clear();
    _added.clear();
    addPatch(_star, to);
    if (_movesPlaces) addPatch(_toStar, _star.middle);
}

void ImageCollapser::collapse(std::uint32_t from)
{
    const std::uint32_t to = _best[from];
    _star.gather(_state.stars, _state.positions, from);
    _shape = shapeOf(_star);
    plan(to);
    _state.ring.replace(_removed, _added);
    for (const Star::Side& side : _star.sidesTo(to))
        --_state.facesOfMaterial[_state.mesh.faces[_star.faces[side.spoked].face].material];
    record(to);
    _state.stars.collapse(from, to, _done.wedgesOf(_done.steps.size() - 1));
    _state.positions[to] = _at;
    _queue.erase(from);
    for (const std::uint32_t neighbour : _star.neighbours)
        touch(neighbour);
    _star.gather(_state.stars, _state.positions, to);
    for (const std::uint32_t neighbour : _star.neighbours)
        touch(neighbour);
    touch(to);
}

/// Marks a position whose star has changed.
void ImageCollapser::touch(std::uint32_t position)
{
    _isStale[position] = true;
    if (!_state.stars.hasFaces(position)) _queue.erase(position);
}

LevelError ImageCollapser::errorOf(std::uint32_t to) const
{
    const Look look{_state.mesh, _state.stars, _state.weight};
    LevelError gap = gapOf({_star, _state.positions, to, _at}, _plan.ofFrom(), look).gap;
    if (_movesPlaces)
        gap = largerOf(gap, gapOf({_toStar, _state.positions, _star.middle, _at}, _plan.ofTo(), look).gap);
    const LevelError& ofTo = _state.errors[to];
    return largerOf(sumOf(_state.errors[_star.middle], gap), _movesPlaces ? sumOf(ofTo, gap) : ofTo);
}

void ImageCollapser::record(std::uint32_t to)
{
    CollapseStep step;
    step.from = _star.middle;
    step.to = to;
    _facesLeft -= static_cast<std::uint32_t>(_star.sidesTo(to).size());
    step.facesAfter = _facesLeft;
    step.error = _state.errors[to] = errorOf(to);
    appendStep(_done, step, _movesPlaces ? &_at : nullptr);
    appendWedges(_done, _plan, &_state.mesh);
}

} // namespace osgPMObjects::core
