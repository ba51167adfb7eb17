// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <glm/glm.hpp>

namespace simulation
{

/// What wheels roll on.
enum class GroundKind : std::uint8_t
{
    asphalt,
    wetAsphalt,
    gravel,
    grass,
    snow,
    ice,
    water ///< carries no wheel
};

/// How a kind of ground resists a tyre.
/// Source: Raymer, *Aircraft Design: A Conceptual Approach*, 1989, table 17.1 (rolling and braked
/// coefficients of runways; ours lie in its ranges, braking relative to dry asphalt).
struct GroundFriction
{
    double gripFactor = 1.0;         ///< of the tyre's friction on dry asphalt
    double rollingResistance = 0.02; ///< force over load of a free wheel
};

constexpr GroundFriction frictionOf(GroundKind kind)
{
    switch (kind)
    {
    case GroundKind::asphalt:
        return {1.0, 0.02};
    case GroundKind::wetAsphalt:
        return {0.6, 0.03};
    case GroundKind::gravel:
        return {0.7, 0.04};
    case GroundKind::grass:
        return {0.6, 0.06};
    case GroundKind::snow:
        return {0.3, 0.07};
    case GroundKind::ice:
        return {0.15, 0.02};
    case GroundKind::water:
        return {0.0, 0.5};
    }
    return {};
}

/// The ground at one point.
struct GroundPoint
{
    double heightM = 0.0;             ///< z of the surface in the scene's frame
    glm::dvec3 normal{0.0, 0.0, 1.0}; ///< of length 1
    GroundKind kind = GroundKind::asphalt;
    bool isKnown = false;   ///< false outside the data
    double gripScale = 1.0; ///< of the friction that its kind has
    double depthM = 5.0;    ///< of water over its bed, where it is water
};

/// The ground as vehicles ask for it. The same question must always have the same answer.
/// Frame: the scene's east-north-up. Units: metres.
class Ground
{
public:
    virtual ~Ground() = default;

    /// Answers for each point what lies below it, or above it where it is under ground; of surfaces over each
    /// other (a bridge), the one that the point stands on. `answers` has the length of `points`.
    virtual void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const = 0;

    /// The same for whoever needs no normals: those of the answers may be left upright.
    virtual void heightsBelow(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const
    {
        below(points, answers);
    }
};

/// Level ground of one kind, for tests and for scenes without terrain.
class LevelGround : public Ground
{
public:
    explicit LevelGround(double heightM = 0.0, GroundKind kind = GroundKind::asphalt)
        : _point{heightM, {0.0, 0.0, 1.0}, kind, true}
    {
    }

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            answers[i] = _point;
    }

private:
    GroundPoint _point;
};

} // namespace simulation
