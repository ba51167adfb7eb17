// SPDX-License-Identifier: Apache-2.0
#include "LeafCollapser.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/Wedge.h>

#include "../patch/RecordCollapse.h"
#include "LeafClosing.h"
#include "LeafError.h"

namespace osgPMObjects::core
{

namespace
{

/// Share of leaves, as its inverse, that merge before partners are searched again. With more at once, visible
/// leaves merge before hidden ones.
constexpr std::size_t kAtOnce = 24;
/// Stretched leaves have corners where leaves were, and mixed normals: they may cost this factor more than
/// others.
constexpr double kStretched = 1.5;
/// The same with subset placement, where leaves of spare corners keep more of the crown than stretched ones.
constexpr double kStretchedOfSubset = 0.5;

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
    _left.resize(_leaves.size());
    std::iota(_left.begin(), _left.end(), 0u);
    while (_left.size() > 1)
    {
        _partners.find(_leaves, _left);
        mergeCheapest();
    }
    removeLast();
    return std::move(_done);
}

void LeafCollapser::mergeCheapest()
{
    std::vector<std::uint32_t> order;
    for (const std::uint32_t leaf : _left)
        if (_partners.of(leaf).leaf != LeafPartners::kNone) order.push_back(leaf);
    const std::size_t most = std::min(order.size(), std::max<std::size_t>(1, _left.size() / kAtOnce));
    std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(most), order.end(),
                      [&](std::uint32_t a, std::uint32_t b)
                      {
                          const double ofA = _partners.of(a).cost, ofB = _partners.of(b).cost;
                          return ofA != ofB ? ofA < ofB : a < b;
                      });
    std::vector<bool> hasChanged(_leaves.size(), false);
    for (std::size_t i = 0; i < most; ++i)
    {
        const std::uint32_t leaf = order[i], partner = _partners.of(leaf).leaf;
        if (hasChanged[leaf] || hasChanged[partner]) continue;
        hasChanged[leaf] = hasChanged[partner] = true;
        merge(leaf, partner);
    }
    std::erase_if(_left, [&](std::uint32_t leaf) { return _leaves[leaf].card.faces.empty(); });
    for (const std::uint32_t leaf : _left)
        if (const std::uint32_t partner = _partners.of(leaf).leaf;
            partner != LeafPartners::kNone && (hasChanged[leaf] || hasChanged[partner]))
            _partners.forget(leaf);
}

LeafGrowth LeafCollapser::growthOf(const Leaf& gone, const Leaf& stays) const
{
    LeafGrowth stretched = stretchedLeaf(_state, gone, stays);
    if (!_state.movesPlaces())
    {
        LeafGrowth ofSpares = leafOfSpares(_state, gone, stays);
        return stretched.loss < kStretchedOfSubset * ofSpares.loss ? stretched : ofSpares;
    }
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
    _urgency = {false, growth.cost + kMissedLeaf * missed};
    _error = leafError(_state, *gone, *stays, growth);
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
        if (!isTaken(corner)) leaf.spares.push_back(gone.card.corners[corner]);
    leaf.spares.insert(leaf.spares.end(), gone.spares.begin(), gone.spares.end());
    if (!growth.spares.empty())
        takeSpares(leaf, growth);
    else if (growth.takesCorners())
        takeCorners(leaf, gone, growth);
    else if (_state.movesPlaces())
        moveCorners(leaf, growth);
}

void LeafCollapser::takeCorners(Leaf& leaf, const Leaf& gone, const LeafGrowth& growth)
{
    for (std::size_t c = 0; c < leaf.card.corners.size(); ++c)
    {
        if (growth.taken[c] == LeafGrowth::kOwn) continue;
        moveTo(leaf.card.corners[c], gone.card.corners[growth.taken[c]]);
    }
}

void LeafCollapser::takeSpares(Leaf& leaf, const LeafGrowth& growth)
{
    for (std::size_t c = 0; c < leaf.card.corners.size(); ++c)
    {
        const auto spare =
            std::find_if(leaf.spares.begin(), leaf.spares.end(),
                         [&](const LeafCard::Corner& s) { return s.position == growth.spares[c]; });
        if (spare == leaf.spares.end()) continue;
        moveTo(leaf.card.corners[c], *spare);
        leaf.spares.erase(spare);
    }
}

/// Replaces a corner of a card by one of a removed card.
void LeafCollapser::moveTo(LeafCard::Corner& own, const LeafCard::Corner& other)
{
    addStep(own.position, other.position, 0, _state.positions[other.position]);
    joinWedges(own, other);
    own = other;
}

/// Moves the corners of a leaf, unless there are too few spare positions: then it grows after further merges.
/// Corners get normals of the removed card, so that a large leaf looks like many, and is not all dark or all
/// bright.
void LeafCollapser::moveCorners(Leaf& leaf, const LeafGrowth& growth)
{
    std::vector<std::size_t> moved;
    for (std::size_t c = 0; c < leaf.card.corners.size(); ++c)
        if (growth.places[c] != _state.positions[leaf.card.corners[c].position]) moved.push_back(c);
    if (moved.size() > leaf.spares.size()) return;
    for (const std::size_t c : moved)
    {
        const std::uint32_t position = leaf.card.corners[c].position;
        const LeafCard::Corner spare = leaf.spares.back();
        leaf.spares.pop_back();
        addStep(spare.position, position, 0, growth.places[c]);
        _state.positions[position] = growth.places[c];
        for (const std::uint32_t wedge : leaf.card.corners[c].wedges)
        {
            Wedge attributes = wedgeOf(_state.mesh, wedge);
            attributes.normal = wedgeOf(_state.mesh, spare.wedges.front()).normal;
            _done.sequence.movedWedges.push_back({wedge, attributes});
            assignWedge(*_state.movedMesh, wedge, attributes);
        }
    }
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
        _urgency.cost += _state.weight.of(last.owedDoubleArea) * kMaterialDistance * kMaterialDistance;
    _error = last.error;
    _error.distance += float(reach);
    close(last, false);
}

void LeafCollapser::addStep(std::uint32_t from, std::uint32_t to, std::uint32_t faces,
                            const glm::dvec3& place)
{
    CollapseStep step;
    step.from = from;
    step.to = to;
    step.facesAfter = faces;
    step.error = _error;
    appendStep(_done.sequence, step, _state.movesPlaces() ? &place : nullptr);
    _done.urgencies.push_back(_urgency);
}

void LeafCollapser::joinWedges(const LeafCard::Corner& from, const LeafCard::Corner& to)
{
    for (const std::uint32_t wedge : from.wedges)
        _done.sequence.wedges.push_back({wedge, mostAlike(_state.mesh, wedge, to.wedges)});
}

} // namespace osgPMObjects::core
