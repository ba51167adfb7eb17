// SPDX-License-Identifier: Apache-2.0
#include "PlaceMover.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "../simplify/patch/PatchCheck.h"

namespace osgPMObjects::core
{

namespace
{

constexpr double kFirstReach = 0.2;          ///< share of the mean length of the edges around
constexpr double kLeastLuminanceGain = 1e-6; ///< squared luminance of a pixel: less is rounding
constexpr std::uint32_t kNoPosition = ~0u;   ///< no position

} // namespace

void PlaceMover::run(CollapseSequence& steps, int rounds)
{
    std::vector<Movable> all = movables(steps);
    for (int round = 0; round < rounds; ++round)
        for (Movable& movable : all)
            if (!improve(movable)) movable.reach *= 0.5;
    for (const Movable& movable : all)
    {
        const glm::dvec3& at = _state.positions[movable.position];
        CollapseStep& step = steps.steps[movable.step];
        step.error.distance += static_cast<float>(glm::distance(at, steps.places[movable.step]));
        steps.places[movable.step] = at;
    }
}

std::vector<PlaceMover::Movable> PlaceMover::movables(const CollapseSequence& steps)
{
    std::vector<std::size_t> lastStep(_state.positions.size(), steps.steps.size());
    for (std::size_t i = 0; i < steps.steps.size(); ++i)
        lastStep[steps.steps[i].to] = i;
    std::vector<Movable> all;
    for (std::uint32_t p = 0; p < lastStep.size(); ++p)
    {
        if (lastStep[p] == steps.steps.size() || !_state.stars.hasFaces(p)) continue;
        _star.gather(_state.stars, _state.positions, p);
        double length = 0.0;
        for (const std::uint32_t neighbour : _star.neighbours)
            length += glm::distance(_state.positions[p], _state.positions[neighbour]);
        all.push_back({p, lastStep[p], kFirstReach * length / static_cast<double>(_star.neighbours.size())});
    }
    return all;
}

/// Tries six directions, along the surface's normal and across, and moves to the best one if it is better.
bool PlaceMover::improve(Movable& movable)
{
    _star.gather(_state.stars, _state.positions, movable.position);
    glm::dvec3 normal(0.0);
    for (const Star::Spoked& spoked : _star.faces)
        normal += spoked.doubleArea * spoked.normal;
    const double length = glm::length(normal);
    const PictureView axes = viewFrom(length > 0.0 ? normal / length : glm::dvec3(0.0, 0.0, 1.0));
    const glm::dvec3 here = _state.positions[movable.position];
    const Quadric quadric = starQuadric(_star, _state.positions, _state.weight,
                                        [](std::span<const Star::Side>) { return false; });
    glm::dvec3 best = here;
    double least = -kLeastLuminanceGain;
    for (const glm::dvec3& way :
         {axes.towardsEye, -axes.towardsEye, axes.right, -axes.right, axes.up, -axes.up})
    {
        const glm::dvec3 at = glm::clamp(here + movable.reach * way, _state.box.low, _state.box.high);
        if (foldsOver({_star, _state.positions, kNoPosition, at})) continue;
        planMove(at);
        const double change =
            _state.ring.change(_removed, _added) + _state.shapeScale * quadric.at(at - here);
        if (change < least) least = change, best = at;
    }
    if (best == here) return false;
    planMove(best);
    _state.ring.replace(_removed, _added);
    _state.positions[movable.position] = best;
    return true;
}

void PlaceMover::planMove(const glm::dvec3& at)
{
    _removed.clear();
    _added.clear();
    for (const Star::Spoked& spoked : _star.faces)
    {
        _removed.push_back(_state.seen(spoked.face));
        _added.push_back(_removed.back());
        const Triangle& p = _state.stars.positions(spoked.face);
        _added.back().corners[p[0] == _star.middle ? 0 : p[1] == _star.middle ? 1 : 2] = at;
    }
}

} // namespace osgPMObjects::core
