// SPDX-License-Identifier: Apache-2.0
#include "Collapser.h"

#include <algorithm>

#include "../patch/RecordCollapse.h"

namespace osgPMObjects::core
{

PartialSequence Collapser::run(std::span<const std::uint32_t> parts)
{
    for (const std::uint32_t part : parts)
        for (const std::uint32_t position : _state.parts[part].positions)
            if (!_state.accumulated.empty())
                _choice.beginAccumulating(position);
            else if (_state.movesPlaces())
                _choice.updateShape(position);
    for (const std::uint32_t part : parts)
        for (const std::uint32_t position : _state.parts[part].positions)
            enter(position);
    while (!_queue.isEmpty())
    {
        const std::uint32_t first = _queue.first();
        if (!isCurrent(first) || _choice.takesLastFaces(first, _state.candidates[first]))
            enter(first);
        else if (_guard && !isAllowed(first, _state.candidates[first].to))
            enterWhatIsAllowed(first);
        else
            collapse(first);
    }
    return std::move(_done);
}

void Collapser::enter(std::uint32_t position)
{
    const bool isLocked = !_state.settings.locked.empty() && _state.settings.locked[position];
    const Candidate best = isLocked ? Candidate() : _choice.bestOf(position);
    _state.candidates[position] = best;
    if (best.to == ~0u)
        _queue.erase(position);
    else
        _queue.set(position, best.urgency);
}

bool Collapser::isCurrent(std::uint32_t position) const
{
    const Candidate& candidate = _state.candidates[position];
    return candidate.changes == _state.changes[position] && _state.stars.hasFaces(candidate.to) &&
           (!_state.movesPlaces() || candidate.changesOfTo == _state.changes[candidate.to]);
}

bool Collapser::isAllowed(std::uint32_t from, std::uint32_t to)
{
    return _guard->allows(from, to, _choice.placeOf(from, to));
}

/// Queues the best collapse that the envelope allows; without one the position waits until its star changes.
void Collapser::enterWhatIsAllowed(std::uint32_t position)
{
    std::vector<std::uint32_t> refused;
    Candidate next = _state.candidates[position];
    do
    {
        refused.push_back(next.to);
        next = _choice.bestOf(position, refused);
    } while (next.to != ~0u && !next.urgency.doesHarm && !isAllowed(position, next.to));
    _state.candidates[position] = next;
    if (next.to == ~0u || next.urgency.doesHarm)
        _queue.erase(position);
    else
        _queue.set(position, next.urgency);
}

bool Collapser::isHasty(const Candidate& candidate) const
{
    constexpr std::uint32_t kMostNeighbours =
        32; // hubs of fans would be re-evaluated for each of their spokes
    if (candidate.neighbours > kMostNeighbours) return false;
    return !_state.movesPlaces() || candidate.urgency.doesHarm || _guard;
}

void Collapser::collapse(std::uint32_t from)
{
    const std::uint32_t to = _state.candidates[from].to;
    const Urgency urgency = _queue.leastUrgency();
    const std::uint32_t step = _state.orbits.isRound() ? _state.orbits.stepFor(from, to) : 0;
    perform(from, to, urgency, nullptr);
    if (_state.orbits.isRound())
        collapseImages(from, to, step, urgency);
    else
        collapseTwin(from, to, urgency);
}

/// Performs the images of a collapse of a round mesh, each after `step` least turns more. Where one is not
/// possible the mesh is round no more. Levels between them are allowed, unlike those between two mirror
/// images: they are many.
/// A position on the axis is its own image: the middle of a flat cap may go before any other, and changes no
/// shape.
void Collapser::collapseImages(std::uint32_t from, std::uint32_t to, std::uint32_t step,
                               const Urgency& urgency)
{
    RotationOrbits& orbits = _state.orbits;
    if (orbits.isOnAxis(from)) return;
    bool isWhole = step > 0;
    for (std::uint32_t turns = step; isWhole && turns < orbits.fold; turns += step)
    {
        const std::uint32_t imageFrom = orbits.imageOf(from, turns), imageTo = orbits.imageOf(to, turns);
        const glm::dvec3 place =
            _state.movesPlaces() ? orbits.imageOf(_state.positions[to], turns) : _state.positions[imageTo];
        isWhole = _choice.isGood(imageFrom, imageTo, place, urgency.cost) &&
                  (!_guard || _guard->allows(imageFrom, imageTo, place));
        if (!isWhole) break;
        perform(imageFrom, imageTo, urgency, &place);
    }
    orbits.step = step;
    if (!isWhole) orbits.fold = 0;
}

/// Performs the mirrored collapse on the other side of a symmetric mesh, if it is still possible there.
void Collapser::collapseTwin(std::uint32_t from, std::uint32_t to, const Urgency& urgency)
{
    MirrorTwins& twins = _state.twins;
    const std::uint32_t twinFrom = twins.of(from), twinTo = twins.of(to);
    if (!twins.isMirrored() || twinTo == MirrorTwins::kNone) return;
    if (twinFrom == from && twinTo == to) return; // both in the plane of symmetry
    if (twinFrom == to)
    { // across the plane: the remaining position is in it, if it could be moved there
        twins.twinOf[to] = _state.movesPlaces() ? to : MirrorTwins::kNone;
        return;
    }
    const glm::dvec3 place = twins.image(_state.positions[to]);
    if (twinFrom != MirrorTwins::kNone && twinFrom != from &&
        _choice.isGood(twinFrom, twinTo, place, urgency.cost) &&
        (!_guard || _guard->allows(twinFrom, twinTo, place)))
    {
        _done.sequence.steps.back().goesOn = true;
        perform(twinFrom, twinTo, urgency, &place);
    }
    else if (_state.movesPlaces())
        twins.twinOf[to] = twins.twinOf[twinTo] = MirrorTwins::kNone;
}

void Collapser::perform(std::uint32_t from, std::uint32_t to, const Urgency& urgency, const glm::dvec3* place)
{
    const CollapseChoice::Effect effect = _choice.effectOf(from, to, place);
    if (_guard) _guard->commit();
    record(from, to, effect);
    _done.urgencies.push_back(urgency);
    _state.joinParts(from, to);
    _state.wentTo[from] = to;
    takeFaces(to);
    _ring = _choice.star().neighbours;
    _state.stars.collapse(from, to, _done.sequence.wedgesOf(_done.sequence.steps.size() - 1));
    if (!_state.accumulated.empty())
        _state.accumulated[to] = _state.accumulated[from].about(effect.at - _state.positions[from]) +
                                 _state.accumulated[to].about(effect.at - _state.positions[to]);
    _state.positions[to] = effect.at;
    _state.errors[to] = effect.error;
    _queue.erase(from);
    refreshAround(to);
}

void Collapser::record(std::uint32_t from, std::uint32_t to, const CollapseChoice::Effect& effect)
{
    CollapseStep step;
    step.from = from;
    step.to = to;
    step.facesAfter = effect.facesGone;
    step.error = effect.error;
    appendStep(_done.sequence, step, _state.movesPlaces() ? &effect.at : nullptr);
    appendWedges(_done.sequence, _choice.wedges(), _state.movedMesh.get());
}

void Collapser::takeFaces(std::uint32_t to)
{
    ConnectedPart& part = _state.part(to);
    for (const Star::Spoked& spoked : _choice.star().faces)
    {
        if (!spoked.has(to)) continue;
        --part.faces;
        for (ConnectedPart::Kept& kept : part.kept)
            kept.faces -= kept.material == _state.mesh.faces[spoked.face].material;
    }
}

void Collapser::refreshAround(std::uint32_t position)
{
    _state.stars.visitStar(position,
                           [&](std::uint32_t face, int)
                           {
                               for (const std::uint32_t p : _state.stars.positions(face))
                                   _ring.push_back(p);
                           });
    _ring.push_back(position);
    std::sort(_ring.begin(), _ring.end());
    _ring.erase(std::unique(_ring.begin(), _ring.end()), _ring.end());
    for (const std::uint32_t p : _ring)
    {
        ++_state.changes[p];
        if (_state.movesPlaces()) _choice.updateShape(p);
    }
    for (const std::uint32_t p : _ring)
    {
        if (!_state.stars.hasFaces(p))
            _queue.erase(p);
        else if (isHasty(_state.candidates[p]))
            enter(p);
    }
}

} // namespace osgPMObjects::core
