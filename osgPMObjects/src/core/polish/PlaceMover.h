// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "../simplify/star/Star.h"
#include "PolishState.h"

namespace osgPMObjects::core
{

/// Moves positions of a level back and forth by decreasing distances, as long as the images improve.
/// Attributes of their wedges stay. No face turns over, and no position leaves the box.
class PlaceMover
{
public:
    explicit PlaceMover(PolishState& state) : _state(state) {}

    /// Moves positions that steps have moved, and updates positions and errors of the last steps that did so.
    /// `steps`: the state's, in its units. Cost: 6 evaluations of the images a position and round.
    void run(CollapseSequence& steps, int rounds);

private:
    struct Movable
    {
        std::uint32_t position = 0;
        std::size_t step = 0; ///< the last one that moved it
        double reach = 0.0;   ///< distance of the next trial
    };

    std::vector<Movable> movables(const CollapseSequence& steps);
    bool improve(Movable& movable);
    void planMove(const glm::dvec3& at);

    PolishState& _state;
    Star _star;
    std::vector<SeenFace> _removed, _added;
};

} // namespace osgPMObjects::core
