// SPDX-License-Identifier: Apache-2.0
#include "LeafCollapser.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/PointGrid.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

/// Search radius of neighbours, as a share of the diagonal of the leaves' box by the cube root of their number: about ten leaves.
constexpr double kNeighbourhood = 0.6;
/// Share of leaves, as its inverse, that merge before partners are searched again. With more at once, visible leaves merge before
/// hidden ones.
constexpr std::size_t kAtOnce = 24;
/// Cost of a removed leaf where it was, in moves by its own size: it is missed there, however near the other one is.
constexpr double kMissed = 2.0;
/// Stretched leaves have corners where leaves were, and mixed normals: they may cost this factor more than others.
constexpr double kStretched = 1.5;

double distanceTo(const LeafCard& card, std::span<const glm::dvec3> places, const glm::dvec3& from)
{
    double squared = std::numeric_limits<double>::infinity();
    for (const LeafCard::Corners& c : card.faces)
    {
        const glm::dvec3 away = from - nearestPoint(from, places[c[0]], places[c[1]], places[c[2]]);
        squared = std::min(squared, glm::dot(away, away));
    }
    return std::sqrt(squared);
}

/// Returns the wedge with the most similar normal.
std::uint32_t mostAlike(const Mesh& mesh, std::uint32_t wedge, std::span<const std::uint32_t> others)
{
    const auto gap = [&](std::uint32_t other)
    { return glm::distance(wedgeOf(mesh, wedge).normal, wedgeOf(mesh, other).normal); };
    return *std::min_element(others.begin(), others.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return gap(a) < gap(b); });
}

} // namespace

PartialSequence LeafCollapser::run(std::vector<LeafCard> cards)
{
    _leaves.reserve(cards.size());
    for (LeafCard& card : cards)
        _leaves.emplace_back(_state, std::move(card));
    _partners.resize(_leaves.size());
    _left.resize(_leaves.size());
    std::iota(_left.begin(), _left.end(), 0u);
    while (_left.size() > 1)
    {
        findPartners();
        mergeCheapest();
    }
    removeLast();
    return std::move(_done);
}

void LeafCollapser::findPartners()
{
    Extent extent;
    for (const std::uint32_t leaf : _left)
        extent.add(_leaves[leaf].middle);
    double distance = kNeighbourhood * std::max(extent.diagonal(), 1e-9) / std::cbrt(double(_left.size()));
    while (findPartners(distance) == 0)
        distance *= 2.0;
}

/// Finds partners for leaves without one. Returns how many leaves have one now.
std::size_t LeafCollapser::findPartners(double distance)
{
    PointGrid grid(distance, _left.size());
    for (const std::uint32_t leaf : _left)
        grid.add(_leaves[leaf].middle);
    std::size_t found = 0;
    for (const std::uint32_t leaf : _left)
    {
        Partner& best = _partners[leaf];
        const glm::dvec3& middle = _leaves[leaf].middle;
        const auto look = [&](std::uint32_t number)
        {
            const std::uint32_t other = _left[number];
            const glm::dvec3 away = _leaves[other].middle - middle;
            if (other == leaf || !(glm::dot(away, away) <= distance * distance)) return;
            const double cost = pairCost(_leaves[leaf], _leaves[other]);
            if (cost < best.cost || (cost == best.cost && other < best.leaf)) best = {cost, other};
        };
        if (best.leaf == ~0u) grid.visitBox(middle - distance, middle + distance, look);
        found += best.leaf != ~0u;
    }
    return found;
}

double LeafCollapser::pairCost(const Leaf& a, const Leaf& b) const
{
    const glm::dvec3 away = a.middle - b.middle;
    const double moved = a.seenDoubleArea * b.seenDoubleArea / (a.seenDoubleArea + b.seenDoubleArea);
    return _state.weight.of(moved) *
           (glm::dot(away, away) + kMissed * std::min(a.owedDoubleArea, b.owedDoubleArea));
}

void LeafCollapser::mergeCheapest()
{
    std::vector<std::uint32_t> order;
    for (const std::uint32_t leaf : _left)
        if (_partners[leaf].leaf != ~0u) order.push_back(leaf);
    const std::size_t most = std::min(order.size(), std::max<std::size_t>(1, _left.size() / kAtOnce));
    std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(most), order.end(),
                      [&](std::uint32_t a, std::uint32_t b)
                      {
                          const double ofA = _partners[a].cost, ofB = _partners[b].cost;
                          return ofA != ofB ? ofA < ofB : a < b;
                      });
    std::vector<bool> hasChanged(_leaves.size(), false);
    for (std::size_t i = 0; i < most; ++i)
    {
        const std::uint32_t leaf = order[i], partner = _partners[leaf].leaf;
        if (hasChanged[leaf] || hasChanged[partner]) continue;
        hasChanged[leaf] = hasChanged[partner] = true;
        merge(leaf, partner);
    }
    std::erase_if(_left, [&](std::uint32_t leaf) { return _leaves[leaf].card.faces.empty(); });
    for (const std::uint32_t leaf : _left)
        if (_partners[leaf].leaf != ~0u && (hasChanged[leaf] || hasChanged[_partners[leaf].leaf]))
            _partners[leaf] = {};
}

LeafGrowth LeafCollapser::growthOf(const Leaf& gone, const Leaf& stays) const
{
    LeafGrowth stretched = stretchedLeaf(_state, gone, stays);
    if (!_state.movesPlaces()) return stretched;
    LeafGrowth scaled = scaledLeaf(_state, gone, stays);
    return stretched.loss < kStretched * scaled.loss ? stretched : scaled;
}

/// Merges two leaves into the one that costs less to keep.
void LeafCollapser::merge(std::uint32_t first, std::uint32_t second)
{
    Leaf *gone = &_leaves[second], *stays = &_leaves[first];
    LeafGrowth growth = growthOf(*gone, *stays), other = growthOf(*stays, *gone);
    if (other.cost < growth.cost)
    {
        std::swap(gone, stays);
        std::swap(growth, other);
    }
    const double missed = _state.weight.of(std::min(gone->seenDoubleArea, stays->seenDoubleArea)) *
                          std::min(gone->owedDoubleArea, stays->owedDoubleArea);
    _urgency = {false, growth.cost + kMissed * missed};
    _error = errorOf(*gone, *stays, growth);
    const std::size_t firstStep = _done.sequence.steps.size();
    close(*gone, growth.isTurned);
    grow(*stays, *gone, growth);
    for (std::size_t s = firstStep; s + 1 < _done.sequence.steps.size(); ++s)
        _done.sequence.steps[s].goesOn = true;
    gone->card.faces.clear();
}

void LeafCollapser::close(const Leaf& leaf, bool isTurned)
{
    const auto& corners = leaf.card.corners;
    for (const LeafClosing::Step& step : closingOf(leaf.card, isTurned).steps)
    {
        addStep(corners[step.from].position, corners[step.to].position, step.faces,
                _state.positions[corners[step.to].position]);
        joinWedges(corners[step.from], corners[step.to]);
    }
}

void LeafCollapser::grow(Leaf& leaf, const Leaf& gone, const LeafGrowth& growth)
{
    leaf.takeOver(gone);
    leaf.error = _error;
    const auto isTaken = [&](std::uint8_t corner)
    { return std::find(growth.taken.begin(), growth.taken.end(), corner) != growth.taken.end(); };
    for (const std::uint8_t corner : closingOf(gone.card, growth.isTurned).left)
        if (!isTaken(corner))
            leaf.spares.push_back(
                {gone.card.corners[corner].position, gone.card.corners[corner].wedges.front()});
    leaf.spares.insert(leaf.spares.end(), gone.spares.begin(), gone.spares.end());
    if (growth.takesCorners())
        takeCorners(leaf, gone, growth);
    else if (_state.movesPlaces())
        moveCorners(leaf, growth);
}

void LeafCollapser::takeCorners(Leaf& leaf, const Leaf& gone, const LeafGrowth& growth)
{
    for (std::size_t c = 0; c < leaf.card.corners.size(); ++c)
    {
        if (growth.taken[c] == LeafGrowth::kOwn) continue;
        LeafCard::Corner& own = leaf.card.corners[c];
        const LeafCard::Corner& other = gone.card.corners[growth.taken[c]];
        addStep(own.position, other.position, 0, growth.places[c]);
        joinWedges(own, other);
        own = other;
    }
}

/// Moves the corners of a leaf, unless there are too few spare positions: then it grows after further merges. Corners get
/// normals of the removed card, so that a large leaf looks like many, and is not all dark or all bright.
void LeafCollapser::moveCorners(Leaf& leaf, const LeafGrowth& growth)
{
    std::vector<std::size_t> moved;
    for (std::size_t c = 0; c < leaf.card.corners.size(); ++c)
        if (growth.places[c] != _state.positions[leaf.card.corners[c].position]) moved.push_back(c);
    if (moved.size() > leaf.spares.size()) return;
    for (const std::size_t c : moved)
    {
        const std::uint32_t position = leaf.card.corners[c].position;
        const Leaf::Spare spare = leaf.spares.back();
        leaf.spares.pop_back();
        addStep(spare.position, position, 0, growth.places[c]);
        _state.positions[position] = growth.places[c];
        for (const std::uint32_t wedge : leaf.card.corners[c].wedges)
        {
            Wedge attributes = wedgeOf(_state.mesh, wedge);
            attributes.normal = wedgeOf(_state.mesh, spare.wedge).normal;
            _done.sequence.movedWedges.push_back({wedge, attributes});
            assignWedge(*_state.movedMesh, wedge, attributes);
        }
    }
}

LevelError LeafCollapser::errorOf(const Leaf& gone, const Leaf& stays, const LeafGrowth& growth) const
{
    std::vector<glm::dvec3> ofGone, before;
    for (const LeafCard::Corner& corner : gone.card.corners)
        ofGone.push_back(_state.positions[corner.position]);
    for (const LeafCard::Corner& corner : stays.card.corners)
        before.push_back(_state.positions[corner.position]);
    double distance = 0.0;
    for (const glm::dvec3& p : ofGone)
        distance = std::max(distance, distanceTo(stays.card, growth.places, p));
    for (const glm::dvec3& p : growth.places)
        distance =
            std::max(distance, std::min(distanceTo(stays.card, before, p), distanceTo(gone.card, ofGone, p)));
    const Wedge a = wedgeOf(_state.mesh, gone.card.corners.front().wedges.front());
    const Wedge b = wedgeOf(_state.mesh, stays.card.corners.front().wedges.front());
    Leaf both = stays; // nothing of either is outside of the box
    both.takeOver(gone);
    distance =
        std::min(distance + std::max(gone.error.distance, stays.error.distance), both.extent.diagonal());
    LevelError error{
        float(distance), std::max({gone.error.normal, stays.error.normal, glm::distance(a.normal, b.normal)}),
        std::max(gone.error.texCoord, stays.error.texCoord), std::max(gone.error.colour, stays.error.colour)};
    for (int channel = 0; channel < 4; ++channel)
        error.colour = std::max(error.colour, std::abs(a.colour[channel] - b.colour[channel]));
    return error;
}

/// Removes the last leaf, as other parts vanish; the last of its material at the cost of a material.
void LeafCollapser::removeLast()
{
    const Leaf& last = _leaves[_left.front()];
    double reach = 0.0;
    for (const LeafCard::Corner& corner : last.card.corners)
        reach = std::max(reach, glm::distance(last.middle, _state.positions[corner.position]));
    _urgency = {false, _state.weight.of(last.owedDoubleArea) * reach * reach};
    if (_state.settings.keepSeams)
        _urgency.cost += _state.weight.of(1.0) * kMaterialDistance * kMaterialDistance;
    _error = last.error;
    _error.distance += float(reach);
    close(last, false);
}

void LeafCollapser::addStep(std::uint32_t from, std::uint32_t to, std::uint32_t faces,
                            const glm::dvec3& place)
{
    CollapseSequence& sequence = _done.sequence;
    CollapseStep step;
    step.from = from;
    step.to = to;
    step.firstWedge = static_cast<std::uint32_t>(sequence.wedges.size());
    step.firstMoved = static_cast<std::uint32_t>(sequence.movedWedges.size());
    step.facesAfter = faces;
    step.error = _error;
    sequence.steps.push_back(step);
    if (_state.movesPlaces()) sequence.places.push_back(place);
    _done.urgencies.push_back(_urgency);
}

void LeafCollapser::joinWedges(const LeafCard::Corner& from, const LeafCard::Corner& to)
{
    for (const std::uint32_t wedge : from.wedges)
        _done.sequence.wedges.push_back({wedge, mostAlike(_state.mesh, wedge, to.wedges)});
}

} // namespace osgPMObjects::core
