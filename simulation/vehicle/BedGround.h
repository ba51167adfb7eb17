// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/Ground.h"

namespace simulation
{

/// A ground whose waters carry nothing: wheels and hulls stand on their beds, which are gravel. Lives no
/// longer than the ground that it asks.
class BedGround final : public Ground
{
public:
    explicit BedGround(const Ground& ground) : _ground(ground) {}

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        _ground.below(points, answers);
        sink(answers);
    }

    void heightsBelow(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        _ground.heightsBelow(points, answers);
        sink(answers);
    }

    /// Whether any point that was asked for since it was made lies under water.
    bool hasWater() const { return _hasWater; }

private:
    void sink(std::span<GroundPoint> answers) const
    {
        for (GroundPoint& answer : answers)
        {
            if (!answer.isKnown || answer.kind != GroundKind::water) continue;
            _hasWater = true;
            answer.heightM -= answer.depthM;
            answer.kind = GroundKind::gravel;
        }
    }

    const Ground& _ground;
    mutable bool _hasWater = false;
};

} // namespace simulation
