// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "../simplify/star/Star.h"
#include "PolishState.h"

namespace osgPMObjects::core
{

/// Moves positions of a level to and fro, in steps that become smaller, as long as the pictures gain. What their wedges look like
/// stays. No face turns over, no place leaves the box.
class PlaceMover
{
public:
    explicit PlaceMover(PolishState& state) : _state(state) {}

    /// Moves positions that steps have put somewhere, and their last steps' places and errors with them.
    /// `steps`: the state's, in its units. Cost: 6 changes of the pictures a position and round.
    void run(CollapseSequence& steps, int rounds);

private:
    struct Movable
    {
        std::uint32_t position = 0;
        std::size_t step = 0; ///< the last that put it somewhere
        double reach = 0.0;   ///< how far it is tried next
    };

    std::vector<Movable> movables(const CollapseSequence& steps);
    bool improve(Movable& movable);
    void planMove(const glm::dvec3& at);

    PolishState& _state;
    Star _star;
    std::vector<SeenFace> _removed, _added;
};

} // namespace osgPMObjects::core
