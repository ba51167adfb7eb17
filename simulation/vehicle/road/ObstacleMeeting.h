// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/contact/GivingContact.h"
#include "simulation/contact/Impact.h"
#include "simulation/contact/MovingObstacle.h"
#include "simulation/contact/ObstacleMap.h"

namespace simulation
{

/// A touch of a vehicle and a thing, in one step.
struct ObstacleTouch
{
    double timeS = 0.0;
    std::uint32_t number = 0; ///< of the thing
    double closingMps = 0.0;
    glm::dvec3 place{0.0};
    glm::dvec3 velocity{0.0}; ///< of the vehicle before
    bool hasGiven = false;
    std::string damage{}; ///< what of the vehicle it broke
};

/// What stands around one vehicle: what of it is near, what of it the vehicle has broken, and the impacts.
/// Touches of one thing that follow each other within kOneImpactS are one impact; those that are slower than
/// kLeastToldMps are none.
class ObstacleMeeting
{
public:
    void meet(std::shared_ptr<const ObstacleMap> obstacles);

    /// These move around the vehicle, until the next call.
    void meetMovers(std::span<const MovingObstacle> movers) { _movers.assign(movers.begin(), movers.end()); }
    std::span<const MovingObstacle> movers() const { return _movers; }

    /// Of those that give, which are not broken.
    bool isBroken(const MovingObstacle& mover) const { return _broken.contains(numberOf(mover.number)); }

    /// The number by which touches of a mover are known.
    static std::uint32_t numberOf(int mover) { return kMovers + static_cast<std::uint32_t>(mover); }

    /// Nothing was hit, nothing is broken.
    void forget();

    /// Looks which things are near; empty where there is no map.
    void look(const glm::dvec2& low, const glm::dvec2& high);

    bool hasMap() const { return _map != nullptr; }
    const ObstacleMap& map() const { return *_map; }

    /// Of the last look, ascending: what stands fast, and what gives and is not broken.
    std::span<const std::uint32_t> fast() const { return _fast; }
    std::span<const std::uint32_t> giving() const { return _giving; }

    void breakDown(std::uint32_t number) { _broken.insert(number); }
    void note(const ObstacleTouch& touch);
    std::span<const Impact> impacts() const { return _impacts; }

    /// Why a vehicle that hit it is no more sound, of a text that lives as long as the program.
    std::string_view reason(std::uint32_t number) const;

    static constexpr std::uint32_t kMovers = 0x8000'0000U; ///< above all numbers of a map
    static constexpr std::uint32_t kGround = 0xffff'fffeU, kWater = 0xffff'ffffU;
    static constexpr double kOneImpactS = 1.0, kLeastToldMps = 0.15;
    static constexpr std::size_t kMostImpacts = 10'000;

private:
    ObstacleKind kindOf(std::uint32_t number) const;
    std::string nameOf(std::uint32_t number) const;

    std::vector<MovingObstacle> _movers;
    std::shared_ptr<const ObstacleMap> _map;
    std::vector<std::uint32_t> _near, _fast, _giving;
    std::set<std::uint32_t> _broken;
    std::vector<Impact> _impacts;
    std::vector<std::uint32_t> _numbers; ///< of the things of the impacts
};

} // namespace simulation
