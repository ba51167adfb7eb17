// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/player/Actor.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Draws trailers behind their vehicles. The coupler of a trailer stays at the hitch, and its axle rolls
/// towards it without slipping sideways: in each step the trailer looks from where its axle was to where the
/// hitch is now (a tractrix).
class Trailers
{
public:
    explicit Trailers(const Scenario& scenario);

    /// Puts the trailers straight behind their vehicles.
    void align(std::vector<Actor>& actors) const;

    /// Draws them on, after the vehicles have moved.
    void follow(std::vector<Actor>& actors) const;

    /// Couples a trailer to what draws it from now on, or (`trailer` below 0) leaves the one that is drawn.
    void couple(int tow, int trailer);

private:
    struct Link
    {
        std::size_t tow = 0, trailer = 0;
        double hitchM = 0.0, couplerM = 0.0; ///< in front of the reference points
    };

    const Scenario* _scenario;
    std::vector<Link> _links; ///< vehicles before what they draw
};

} // namespace simulation
