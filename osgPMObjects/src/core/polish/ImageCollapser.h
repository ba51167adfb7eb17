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

/// Collapses a level to fewer faces, by the collapse that changes the images least.
/// Candidates of a position are its collapses of least quadric cost. Those around a collapse are re-evaluated
/// when they come first in the queue; those before or behind it in some view keep their cost.
/// Source: Lindstrom and Turk, *Image-driven simplification* (2000); Cohen, Manocha and Olano, *Simplifying
/// polygonal models using successive mappings* (1997), section 5 (lazy queue).
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

    /// Returns the steps, with the state's numbers; positions and errors in the state's unit.
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
    std::vector<std::uint32_t> _best; ///< by position: the neighbour it merges into
    std::vector<bool> _isStale;       ///< by position: its star has changed since the choice
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
