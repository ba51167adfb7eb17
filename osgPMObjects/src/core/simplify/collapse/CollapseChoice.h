// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../patch/PatchCheck.h"
#include "../patch/WedgePlan.h"
#include "../star/Star.h"
#include "CollapseState.h"

namespace osgPMObjects::core
{

/// Chooses the neighbour into which a position merges at the least cost.
/// Threads: one object each, on different parts.
class CollapseChoice
{
public:
    explicit CollapseChoice(CollapseState& state) : _state(state) {}

    /// Recomputes the shape of a position's star and stores it in the state.
    void updateShape(std::uint32_t position);

    /// Begins the accumulated quadric of a position with the planes around it.
    void beginAccumulating(std::uint32_t position);

    /// Returns the best collapse of a position; `to` is ~0 where it has no faces. `refused`: neighbours to
    /// exclude.
    Candidate bestOf(std::uint32_t position, std::span<const std::uint32_t> refused = {});

    /// Returns the position of both after the collapse, in the state's frame.
    glm::dvec3 placeOf(std::uint32_t from, std::uint32_t to);

    /// Whether a collapse would now remove the last faces of a part or a material, at a higher cost than its
    /// candidate has: other collapses may have removed the rest since.
    bool takesLastFaces(std::uint32_t from, const Candidate& candidate);

    /// The effect of a collapse.
    struct Effect
    {
        glm::dvec3 at{0.0}; ///< position of both afterwards
        LevelError error;   ///< of everything merged into `to`, this collapse included
        std::uint32_t facesGone = 0;
    };

    /// Computes a collapse; wedges() gives the changes of wedges. Both positions move to `place` where it is
    /// given.
    Effect effectOf(std::uint32_t from, std::uint32_t to, const glm::dvec3* place = nullptr);
    /// Whether a collapse is possible, turns no face over, and costs at most about `cost`.
    bool isGood(std::uint32_t from, std::uint32_t to, const glm::dvec3& place, double cost);
    const WedgePlan& wedges() const { return _plan; }
    /// The faces around `from` of the latest query.
    const Star& star() const { return _star; }

private:
    StarShape shapeOf(const Star& star) const;
    /// The position of the collapsed edge, and the quadric cost there.
    struct Place
    {
        glm::dvec3 at{0.0};
        double cost = 0.0;
    };
    Place placeFor(std::uint32_t to) const;
    Place placeByHistory(std::uint32_t to) const;
    glm::dvec3 allowedPlace(std::uint32_t to, const glm::dvec3& wanted) const;
    glm::dvec3 placeKeepingLastArea(std::uint32_t to);
    bool staysOnItsLines(std::uint32_t to) const;
    double featureCost(std::uint32_t to) const;
    void gather(Star& star, std::uint32_t position) const
    {
        star.gather(_state.stars, _state.positions, position);
    }
    void planWedges(std::uint32_t to, const glm::dvec3& at);
    PatchGap gapTo(std::uint32_t to, const glm::dvec3& at, bool withLook);
    bool isLopsided(std::uint32_t to) const;
    PatchTurn turnTo(std::uint32_t to, const glm::dvec3& at);
    double driftCost(const PatchGap& gap) const;
    Candidate candidate(std::uint32_t to);

    CollapseState& _state;
    Star _star, _toStar;
    WedgePlan _plan;
    std::vector<Candidate> _ranked;
};

} // namespace osgPMObjects::core
