// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "../simplify/collapse/CollapseQueue.h"
#include "../simplify/patch/WedgePlan.h"
#include "../simplify/quadric/Placement.h"
#include "../simplify/star/Star.h"
#include "PolishState.h"

namespace osgPMObjects::core
{

/// Collapses a level to fewer faces, again and again what changes the pictures least.
/// Each position's cheapest collapses by their quadrics are tried on the pictures; those around a collapse are tried again when their
/// turn comes, and what lies before or behind it in some view keeps its cost.
/// Source: Lindstrom and Turk (2000); Cohen, Manocha and Olano (1997), §5 (lazy queue).
class ImageCollapser
{
public:
    ImageCollapser(PolishState& state, const PolishSettings& settings, bool movesPlaces)
        : _state(state),
          _settings(settings),
          _movesPlaces(movesPlaces),
          _queue(state.positions.size()),
          _best(state.positions.size(), ~0u),
          _isStale(state.positions.size(), false)
    {
    }

    /// The steps, numbered as the state's mesh; places and errors in the state's unit.
    CollapseSequence run(std::size_t targetFaces);

private:
    struct Ranked
    {
        std::uint32_t to = ~0u;
        double shapeCost = 0.0;
    };

    struct Place
    {
        glm::dvec3 at{0.0};
        double cost = 0.0;
    };

    StarShape shapeOf(const Star& star) const;
    void rank(std::uint32_t position);
    Place placeFor(std::uint32_t to);
    void enter(std::uint32_t position);
    Urgency urgencyOf(const Ranked& ranked);
    bool isHarmful(std::uint32_t to, const glm::dvec3& at) const;
    void plan(std::uint32_t to);
    void addPatch(const Star& star, std::uint32_t besides);
    Wedge wedgeAfter(std::uint32_t wedge, bool isOfFrom) const;
    void collapse(std::uint32_t from);
    void record(std::uint32_t to);
    LevelError errorOf(std::uint32_t to) const;
    void touch(std::uint32_t position);

    PolishState& _state;
    const PolishSettings& _settings;
    bool _movesPlaces;
    CollapseQueue _queue;
    std::vector<std::uint32_t> _best; ///< by position: the neighbour it goes into
    std::vector<bool> _isStale;       ///< by position: its star has changed since
    Star _star, _toStar;
    StarShape _shape;
    WedgePlan _plan;
    glm::dvec3 _at{0.0};
    std::vector<Ranked> _ranked;
    std::vector<SeenFace> _removed, _added;
    CollapseSequence _done;
    std::uint32_t _facesLeft = 0;
};

} // namespace osgPMObjects::core
