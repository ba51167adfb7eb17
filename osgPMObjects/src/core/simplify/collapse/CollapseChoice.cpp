// SPDX-License-Identifier: Apache-2.0
#include "CollapseChoice.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "../../mesh/Squared.h"
#include "../quadric/KeepArea.h"
#include "../sequence/LevelErrors.h"
#include "../symmetry/TwinFolds.h"

namespace osgPMObjects::core
{

namespace
{

/// Weight of the edge's length, as a share of the whole quadric at its other end: decides among collapses of
/// equal cost.
constexpr double kShortness = 1e-6;
/// The most that texture drift costs, as a distance of the patch and a share of the diagonal.
constexpr double kDriftDistance = 0.02;
/// Cost factor of a collapse that breaks the symmetry.
constexpr double kLopsided = 1e3;
/// A material counts as if twice its area were at least this, where the diagonal is 1: a spot may be a mark.
constexpr double kLeastMaterialArea = 5e-4;
/// The most neighbours of a position that are evaluated in full: those of the least quadric cost.
constexpr std::size_t kMostTried = 24;

/// Whether a collapse may remove the last faces of a part, or of a material that the part keeps.
bool hasFewFaces(const ConnectedPart& part)
{
    constexpr std::uint32_t kFew = 8;
    return part.faces <= kFew || std::any_of(part.kept.begin(), part.kept.end(),
                                             [](const ConnectedPart::Kept& k) { return k.faces <= kFew; });
}

/// Whether an edge is a border of appearance: another material, or other texture coordinates or colours at
/// its near end. Different normals are a crease only, which the shape itself has.
bool isBorder(const CollapseState& state, const Star& star, std::span<const Star::Side> sides)
{
    const Star::Spoked& first = star.faces[sides.front().spoked];
    for (const Star::Side& side : sides.subspan(1))
    {
        const Star::Spoked& other = star.faces[side.spoked];
        const Mesh& mesh = state.mesh;
        if (mesh.faces[first.face].material != mesh.faces[other.face].material) return true;
        if (first.wedge == other.wedge) continue;
        Wedge a = wedgeOf(mesh, first.wedge), b = wedgeOf(mesh, other.wedge);
        if (a.texCoords != b.texCoords || a.colour != b.colour) return true;
    }
    return false;
}

/// Whether a face that stays has no area left in plan, or the other side up, when the middle of its star
/// merges into `to` at `at`.
bool turnsOverInPlan(const Star& star, std::span<const glm::dvec3> positions, std::uint32_t to,
                     const glm::dvec3& at)
{
    constexpr double kLeastArea = 1e-9; ///< in the unit frame: above what rounding makes of none
    return std::any_of(star.faces.begin(), star.faces.end(),
                       [&](const Star::Spoked& spoked)
                       {
                           if (spoked.has(to)) return false;
                           const glm::dvec3 a = positions[spoked.second] - at,
                                            b = positions[spoked.third] - at;
                           return a.x * b.y - a.y * b.x < kLeastArea;
                       });
}

/// Whether a face that stays lies between three positions of one line, when the middle of its star merges
/// into `to`.
bool liesOnALine(const Star& star, std::span<const std::uint8_t> lines, std::uint32_t to)
{
    return std::any_of(star.faces.begin(), star.faces.end(),
                       [&](const Star::Spoked& spoked) {
                           return !spoked.has(to) &&
                                  (lines[to] & lines[spoked.second] & lines[spoked.third]) != 0;
                       });
}

} // namespace

/// Whether the middle of the star may merge into a position, by the lines on which both lie.
bool CollapseChoice::staysOnItsLines(std::uint32_t to) const
{
    const std::vector<std::uint8_t>& lines = _state.settings.lines;
    return lines.empty() || (lines[_star.middle] & ~lines[to]) == 0;
}

StarShape CollapseChoice::shapeOf(const Star& star) const
{
    const auto border = [&](std::span<const Star::Side> sides)
    { return _state.settings.keepSeams && isBorder(_state, star, sides); };
    return starShape(star, _state.positions, _state.weight, border);
}

void CollapseChoice::updateShape(std::uint32_t position)
{
    gather(_star, position);
    _state.shapes[position] = shapeOf(_star);
}

void CollapseChoice::beginAccumulating(std::uint32_t position)
{
    updateShape(position);
    _state.accumulated[position] = {_state.shapes[position].quadric};
}

/// The place and the cost by accumulated quadrics.
CollapseChoice::Place CollapseChoice::placeByHistory(std::uint32_t to) const
{
    const glm::dvec3 &here = _state.positions[_star.middle], &there = _state.positions[to];
    const AccumulatedQuadric &from = _state.accumulated[_star.middle], &into = _state.accumulated[to];
    if (!_state.movesPlaces()) return {there, std::max(0.0, from.at(there - here) + into.constant)};
    const CollapsingEdge edge{here, there, _state.shapes[_star.middle], _state.shapes[to],
                              sharedAreaVector(_star, to)};
    const glm::dvec3 half = 0.5 * (there - here);
    const glm::dvec3 at = allowedPlace(to, bestPlace(edge, from.about(half) + into.about(-half)));
    return {at, std::max(0.0, from.at(at - here) + into.at(at - there))};
}

CollapseChoice::Place CollapseChoice::placeFor(std::uint32_t to) const
{
    if (!_state.accumulated.empty()) return placeByHistory(to);
    const glm::dvec3 &here = _state.positions[_star.middle], &there = _state.positions[to];
    const StarShape& shape = _state.shapes[_star.middle];
    if (!_state.movesPlaces()) return {there, std::max(0.0, shape.quadric.at(there - here))};
    const CollapsingEdge edge{here, there, shape, _state.shapes[to], sharedAreaVector(_star, to)};
    const glm::dvec3 at = allowedPlace(to, bestPlace(edge));
    return {at, costAt(edge, at)};
}

/// Returns the nearest place in the box of the mesh, and in the plane of symmetry or on the axis where the
/// collapse is to stay there.
glm::dvec3 CollapseChoice::allowedPlace(std::uint32_t to, const glm::dvec3& wanted) const
{
    glm::dvec3 at = glm::clamp(wanted, _state.box.low, _state.box.high);
    const MirrorTwins& twins = _state.twins;
    if (twins.isInPlane(to) || twins.of(to) == _star.middle) at[twins.axis] = 0.0;
    const RotationOrbits& orbits = _state.orbits;
    if (!orbits.isRound()) return at;
    if (orbits.isOnAxis(to)) return orbits.within(at, 0.0);
    if (orbits.isOnAxis(_star.middle)) return _state.positions[to]; // it has no image that would go elsewhere
    return orbits.within(at, orbits.radiusIn(_state.box));
}

/// Returns the place of a collapse. The last faces of a part keep their area with optimal placement, so that
/// it does not shrink before it vanishes; unless a face turns over there.
glm::dvec3 CollapseChoice::placeKeepingLastArea(std::uint32_t to)
{
    constexpr std::uint32_t kLastFaces = 16;
    const glm::dvec3 best = placeFor(to).at;
    const ConnectedPart& part = _state.part(to);
    const double most = _state.areaCost.mostSwelling * std::sqrt(part.doubleArea);
    if (_state.settings.placement != Placement::optimal || part.faces > kLastFaces || !(most > 0.0))
        return best;
    const glm::dvec3 at = allowedPlace(to, placeKeepingArea({_star, _toStar, _state.positions}, best, most));
    return turnTo(to, at).foldsOver ? best : at;
}

/// Whether a collapse breaks the symmetry of the mesh, even with its mirror image done.
bool CollapseChoice::isLopsided(std::uint32_t to) const
{
    const RotationOrbits& orbits = _state.orbits;
    if (orbits.isRound())
        return orbits.isOnAxis(_star.middle) ? !orbits.isOnAxis(to) : orbits.stepFor(_star.middle, to) == 0;
    const MirrorTwins& twins = _state.twins;
    if (!twins.isMirrored()) return false;
    if (twins.isInPlane(_star.middle)) return !twins.isInPlane(to);
    if (twins.of(to) == _star.middle) return !_state.movesPlaces();
    return _state.positions[_star.middle][twins.axis] * _state.positions[to][twins.axis] < 0.0;
}

/// The cost of removing the last faces of a part or a material.
double CollapseChoice::featureCost(std::uint32_t to) const
{
    const ConnectedPart& part = _state.part(to);
    if (!hasFewFaces(part)) return 0.0;
    const auto going = _star.sidesTo(to);
    double cost = 0.0;
    if (going.size() >= part.faces) cost = _state.weight.of(part.doubleArea) * squared(part.reach);
    if (!_state.settings.keepSeams) return cost;
    for (const ConnectedPart::Kept& kept : part.kept)
    {
        if (kept.faces > going.size()) continue;
        const auto ofKind = std::count_if(
            going.begin(), going.end(),
            [&](const Star::Side& side)
            { return _state.mesh.faces[_star.faces[side.spoked].face].material == kept.material; });
        if (ofKind > 0 && ofKind >= static_cast<std::ptrdiff_t>(kept.faces))
            cost += _state.weight.of(std::max(kept.doubleArea, kLeastMaterialArea)) *
                    squared(kMaterialDistance * kept.contrast);
    }
    return cost;
}

Candidate CollapseChoice::candidate(std::uint32_t to)
{
    Candidate candidate{to,
                        _state.changes[_star.middle],
                        _state.changes[to],
                        static_cast<std::uint32_t>(_star.neighbours.size()),
                        {}};
    const glm::dvec3 edge = _state.positions[to] - _state.positions[_star.middle];
    candidate.urgency.cost = placeFor(to).cost + featureCost(to) +
                             kShortness * _state.shapes[_star.middle].quadric.trace() * glm::dot(edge, edge);
    if (isLopsided(to)) candidate.urgency.cost *= kLopsided;
    return candidate;
}

void CollapseChoice::planWedges(std::uint32_t to, const glm::dvec3& at)
{
    if (!_state.movesPlaces()) return _plan.match({_state.stars, _state.mesh, _state.positions}, _star, to);
    _plan.resample({_state.stars, _state.mesh, _state.positions}, _star, _toStar, at);
}

PatchGap CollapseChoice::gapTo(std::uint32_t to, const glm::dvec3& at, bool withLook)
{
    const Patch patch{_star, _state.positions, to, at};
    const Patch toPatch{_toStar, _state.positions, _star.middle, at};
    if (!withLook)
    {
        PatchGap gap;
        gap.gap.distance = distanceFrom(patch);
        if (_state.movesPlaces()) gap.gap.distance = std::max(gap.gap.distance, distanceFrom(toPatch));
        return gap;
    }
    const Look look{_state.mesh, _state.stars, _state.weight};
    PatchGap gap = gapOf(patch, _plan.ofFrom(), look);
    if (!_state.movesPlaces()) return gap;
    const PatchGap ofTo = gapOf(toPatch, _plan.ofTo(), look);
    return {largerOf(gap.gap, ofTo.gap), gap.slipCost + ofTo.slipCost,
            std::max(gap.lengthPerTexture, ofTo.lengthPerTexture)};
}

PatchTurn CollapseChoice::turnTo(std::uint32_t to, const glm::dvec3& at)
{
    if (_state.settings.isHeightField && turnsOverInPlan(_star, _state.positions, to, at)) return {true, 0.0};
    if (!_state.settings.lines.empty() && liesOnALine(_star, _state.settings.lines, to)) return {true, 0.0};
    const PatchTurn folded{true, 0.0};
    PatchTurn turn = turnOf({_star, _state.positions, to, at});
    if (turn.foldsOver || foldsWithTwin(_state.twins, _state.positions, _star, to, at)) return folded;
    for (const Star::Side& side : _star.sidesTo(to))
        turn.doubleArea -= _star.faces[side.spoked].doubleArea;
    if (!_state.movesPlaces()) return turn;
    const PatchTurn ofTo = turnOf({_toStar, _state.positions, _star.middle, at});
    if (ofTo.foldsOver || foldsWithTwin(_state.twins, _state.positions, _toStar, _star.middle, at))
        return folded;
    turn.doubleArea += ofTo.doubleArea;
    return turn;
}

/// The cost of texture drift that has added up beyond what is allowed: that of a displacement along the
/// surface by as much, at most by kDriftDistance. So it counts as the surface's own distance does, at
/// whatever size the level is shown.
double CollapseChoice::driftCost(const PatchGap& gap) const
{
    const double drift = _state.errors[_star.middle].texCoord + gap.gap.texCoord;
    if (!(drift > _state.settings.mostTexCoordDrift)) return 0.0;
    return _state.weight.of(glm::length(_state.shapes[_star.middle].areaVector)) *
           squared(std::min(kDriftDistance, drift * gap.lengthPerTexture));
}

Candidate CollapseChoice::bestOf(std::uint32_t position, std::span<const std::uint32_t> refused)
{
    gather(_star, position);
    if (!_state.movesPlaces()) _state.shapes[position] = shapeOf(_star);
    _ranked.clear();
    for (const std::uint32_t to : _star.neighbours)
        if (staysOnItsLines(to) && std::find(refused.begin(), refused.end(), to) == refused.end())
            _ranked.push_back(candidate(to));
    const std::uint32_t nearby = _state.nearbyNow(position);
    if (nearby != ~0u && !_ranked.empty() &&
        !std::binary_search(_star.neighbours.begin(), _star.neighbours.end(), nearby))
        _ranked.push_back(candidate(nearby));
    const auto byUrgency = [](const Candidate& a, const Candidate& b)
    { return a.urgency != b.urgency ? a.urgency < b.urgency : a.to < b.to; };
    std::sort(_ranked.begin(), _ranked.end(), byUrgency);
    if (_ranked.size() > kMostTried) _ranked.resize(kMostTried);
    Candidate best;
    for (Candidate& candidate : _ranked)
    {
        if (best.to != ~0u && !best.urgency.doesHarm && best.urgency.cost <= candidate.urgency.cost) break;
        if (_state.movesPlaces()) gather(_toStar, candidate.to);
        const glm::dvec3 at = placeKeepingLastArea(candidate.to);
        const PatchTurn turn = turnTo(candidate.to, at);
        candidate.urgency.doesHarm = turn.foldsOver;
        candidate.urgency.cost +=
            _state.areaCost.of(_star, turn.doubleArea) * (isLopsided(candidate.to) ? kLopsided : 1.0);
        if (_state.settings.keepSeams)
        {
            planWedges(candidate.to, at);
            const PatchGap gap = gapTo(candidate.to, at, true);
            candidate.urgency.cost += gap.slipCost + driftCost(gap);
        }
        if (best.to == ~0u || byUrgency(candidate, best)) best = candidate;
    }
    return best;
}

glm::dvec3 CollapseChoice::placeOf(std::uint32_t from, std::uint32_t to)
{
    gather(_star, from);
    return placeFor(to).at;
}

bool CollapseChoice::isGood(std::uint32_t from, std::uint32_t to, const glm::dvec3& place, double cost)
{
    constexpr double kAbout = 64.0; // tolerance: the collapse on the other side may have changed this one
    gather(_star, from);
    if (!std::binary_search(_star.neighbours.begin(), _star.neighbours.end(), to)) return false;
    if (_state.movesPlaces()) gather(_toStar, to);
    return !turnTo(to, place).foldsOver && featureCost(to) <= kAbout * cost;
}

bool CollapseChoice::takesLastFaces(std::uint32_t from, const Candidate& candidate)
{
    if (!hasFewFaces(_state.part(from))) return false;
    gather(_star, from);
    return featureCost(candidate.to) > candidate.urgency.cost;
}

CollapseChoice::Effect CollapseChoice::effectOf(std::uint32_t from, std::uint32_t to, const glm::dvec3* place)
{
    gather(_star, from);
    if (_state.movesPlaces()) gather(_toStar, to);
    Effect effect;
    effect.at = place != nullptr ? *place : placeKeepingLastArea(to);
    planWedges(to, effect.at);
    LevelError gap = gapTo(to, effect.at, _state.settings.keepSeams).gap;
    effect.facesGone = static_cast<std::uint32_t>(_star.sidesTo(to).size());
    const ConnectedPart& part = _state.part(to);
    if (effect.facesGone >= part.faces) gap.distance = std::max(gap.distance, static_cast<float>(part.reach));
    const LevelError& ofTo = _state.errors[to];
    effect.error = largerOf(sumOf(_state.errors[from], gap), _state.movesPlaces() ? sumOf(ofTo, gap) : ofTo);
    return effect;
}

} // namespace osgPMObjects::core
