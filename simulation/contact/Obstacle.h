// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <glm/glm.hpp>

namespace simulation
{

/// What stands in the way.
enum class ObstacleKind : std::uint8_t
{
    house,
    wall,
    fence,
    guardRail,
    barrier,
    bridgeRail,
    tunnelWall,
    pillar,
    mast,   ///< lamp posts, traffic lights, gantries, pylons, bollards
    post,   ///< of signs: it breaks
    marker, ///< cones and delineators: they give way
    tree,
    hedge, ///< bushes: they slow
    vehicle,
    thing,  ///< anything else
    person, ///< on foot: gives way
    ground, ///< the terrain; never in a map
    water,  ///< never in a map
    count
};

/// How many kinds stand somewhere: those before `ground`.
inline constexpr int kStandingKinds = static_cast<int>(ObstacleKind::ground);

/// How a kind meets vehicles. What neither breaks nor slows stands fast.
struct ObstacleFacts
{
    std::string_view name;
    double friction = 1.0;  ///< times that of a vehicle's hull
    double breaksNs = 0.0;  ///< the impulse that breaks it, N s; 0: it does not break
    double slowsPerM = 0.0; ///< deceleration over the square of the speed, 1/m; 0: it does not slow
    double slowsMps2 = 0.0; ///< deceleration at any speed
};

/// The facts of a kind. Source: chosen here; a sign's post within what EN 12767 tests as passively safe (a
/// car of 900 kg leaves it with 70 to 100 % of its speed), rails with the friction of steel on paint.
constexpr ObstacleFacts factsOf(ObstacleKind kind)
{
    constexpr std::array<ObstacleFacts, static_cast<std::size_t>(ObstacleKind::count)> kFacts{{
        {"house"},
        {"wall"},
        {"fence", 1.0, 1200.0},
        {"guard rail", 0.5},
        {"barrier", 0.8},
        {"bridge rail", 0.5},
        {"tunnel wall"},
        {"pillar"},
        {"mast"},
        {"post", 1.0, 600.0},
        {"marker", 1.0, 60.0},
        {"tree"},
        {"hedge", 1.0, 0.0, 0.02, 1.5},
        {"vehicle"},
        {"thing"},
        {"person", 1.0, 400.0},
        {"ground"},
        {"water"},
    }};
    return kFacts[static_cast<std::size_t>(kind)];
}

constexpr bool standsFast(ObstacleKind kind)
{
    const ObstacleFacts facts = factsOf(kind);
    return facts.breaksNs == 0.0 && facts.slowsPerM == 0.0;
}

/// Something upright that vehicles may hit: a box turned in the plan, or a round body.
/// Frame: the scene's east-north-up. Units: metres.
struct Obstacle
{
    ObstacleKind kind = ObstacleKind::thing;
    bool isRound = false;
    std::uint16_t name = 0;         ///< into the names of its map
    glm::dvec2 middle{0.0};         ///< in the plan
    glm::dvec2 along{1.0, 0.0};     ///< unit vector of its length
    glm::dvec2 halfM{0.5};          ///< half its length and width; of a round one x is the radius
    double lowM = 0.0, highM = 1.0; ///< z of its foot and top

    /// Half the sides of the upright rectangle around it.
    glm::dvec2 reachM() const
    {
        if (isRound) return glm::dvec2(halfM.x);
        return {halfM.x * glm::abs(along.x) + halfM.y * glm::abs(along.y),
                halfM.x * glm::abs(along.y) + halfM.y * glm::abs(along.x)};
    }
};

/// A straight piece of something thin between two places of the plan: a wall, a rail.
inline Obstacle pieceBetween(ObstacleKind kind, const glm::dvec2& from, const glm::dvec2& to, double widthM)
{
    Obstacle piece;
    piece.kind = kind;
    piece.middle = 0.5 * (from + to);
    const double lengthM = glm::length(to - from);
    if (lengthM > 1e-9) piece.along = (to - from) / lengthM;
    piece.halfM = {0.5 * lengthM, 0.5 * widthM};
    return piece;
}

} // namespace simulation
