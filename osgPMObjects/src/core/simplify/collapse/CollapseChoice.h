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

/// Finds for a position the neighbour it goes into with the least loss.
/// Threads: one object each, on different parts.
class CollapseChoice
{
public:
    explicit CollapseChoice(CollapseState& state) : _state(state) {}

    /// What a position's star is now. Keeps it in the state.
    void updateShape(std::uint32_t position);

    /// The best collapse of a position; `to` is ~0 where it has no faces.
    /// `refused`: neighbours that do not come into question.
    Candidate bestOf(std::uint32_t position, std::span<const std::uint32_t> refused = {});

    /// Where both would be.
    glm::dvec3 placeOf(std::uint32_t from, std::uint32_t to);

    /// Whether a collapse would now take the last faces of a part or a material, and costs more than was thought: others may have
    /// taken the rest since.
    bool takesLastFaces(std::uint32_t from, const Candidate& candidate);

    /// What a collapse does.
    struct Effect
    {
        glm::dvec3 at{0.0}; ///< where both are afterwards
        LevelError error;   ///< of what has gone into `to`, with this
        std::uint32_t facesGone = 0;
    };

    /// Works a collapse out; wedges() tells what becomes of them. With a place given, both go there.
    Effect effectOf(std::uint32_t from, std::uint32_t to, const glm::dvec3* place = nullptr);
    /// Whether a collapse is possible, turns no face over, and costs no more than about so much.
    bool isGood(std::uint32_t from, std::uint32_t to, const glm::dvec3& place, double cost);
    const WedgePlan& wedges() const { return _plan; }
    /// The faces around `from` of the last question.
    const Star& star() const { return _star; }

private:
    StarShape shapeOf(const Star& star) const;
    /// Where two positions become one, and the quadric there.
    struct Place
    {
        glm::dvec3 at{0.0};
        double cost = 0.0;
    };
    Place placeFor(std::uint32_t to) const;
    double featureCost(std::uint32_t to) const;
    void gather(Star& star, std::uint32_t position) const
    {
        star.gather(_state.stars, _state.positions, position);
    }
    void planWedges(std::uint32_t to, const glm::dvec3& at);
    PatchGap gapTo(std::uint32_t to, const glm::dvec3& at, bool withLook);
    bool isLopsided(std::uint32_t to) const;
    bool foldsWithTwin(const Star& star, std::uint32_t other, const glm::dvec3& at) const;
    bool isHarmful(std::uint32_t to, const glm::dvec3& at);
    Candidate candidate(std::uint32_t to);

    CollapseState& _state;
    Star _star, _toStar;
    WedgePlan _plan;
    std::vector<Candidate> _ranked;
};

} // namespace osgPMObjects::core
