// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "simulation/scenario/Entity.h"
#include "simulation/scenario/Position.h"

// Source: ASAM OpenSCENARIO XML 1.0 to 1.3, TrafficAction. Units: metres, seconds.

namespace simulation
{

/// One kind of vehicle in traffic, and how often it is taken among the others.
struct TrafficKind
{
    double weight = 1.0;
    ScenarioObject object; ///< without a name; its controllers drive it

    bool operator==(const TrafficKind&) const = default;
};

/// What traffic consists of. Both lists may be empty: cars, with the usual controller.
struct TrafficMix
{
    struct Driver
    {
        double weight = 1.0;
        Controller controller;

        bool operator==(const Driver&) const = default;
    };

    std::vector<TrafficKind> kinds;
    std::vector<Driver> drivers; ///< for all kinds that bring no controller of their own

    bool operator==(const TrafficMix&) const = default;
};

/// Lets vehicles appear around a place, one after the other.
struct TrafficSource
{
    double perSecond = 1.0;
    double radiusM = 0.0;
    std::optional<double> speedMps;
    Position position;
    TrafficMix mix;

    bool operator==(const TrafficSource&) const = default;
};

/// Lets vehicles vanish that come near a place.
struct TrafficSink
{
    std::optional<double> perSecond; ///< nothing: all of them; 0: none
    double radiusM = 0.0;
    Position position;
    std::vector<std::string> categories; ///< of the vehicles that vanish; empty: all

    bool operator==(const TrafficSink&) const = default;
};

struct SpeedRange
{
    double leastMps = 0.0, mostMps = 0.0;

    bool operator==(const SpeedRange&) const = default;
};

/// Keeps vehicles around an entity: within an ellipse, outside a circle in its middle.
struct TrafficSwarm
{
    std::string central;
    double semiMajorM = 0.0; ///< along the entity
    double semiMinorM = 0.0;
    double innerRadiusM = 0.0;
    double offsetM = 0.0; ///< of the ellipse's middle ahead of the entity
    int count = 0;

    /// Vehicles a kilometre of street in the ellipse, up to `count`, which keep the rules; nothing: `count`.
    /// Scenarios of the standard have none.
    std::optional<double> perKm{};
    std::optional<SpeedRange> speed;
    double sameDirection = 1.0, oppositeDirection = 1.0; ///< weights
    TrafficMix mix;

    bool operator==(const TrafficSwarm&) const = default;
};

/// A stretch of one road. Without lanes: all that cars drive on.
struct RoadStretch
{
    std::string roadId;
    double fromM = 0.0;
    std::optional<double> toM; ///< nothing: to the road's end
    std::vector<int> lanes;

    bool operator==(const RoadStretch&) const = default;
};

/// Puts vehicles into an area; a continuous one replaces those that leave it.
struct TrafficArea
{
    bool isContinuous = false;
    int count = 0;
    std::vector<Position> corners; ///< of a polygon seen from above; or
    std::vector<RoadStretch> stretches;
    TrafficMix mix;

    bool operator==(const TrafficArea&) const = default;
};

/// Ends the traffic actions of its name; vehicles that are there drive on.
struct TrafficStop
{
    bool operator==(const TrafficStop&) const = default;
};

struct TrafficAction
{
    static constexpr std::string_view kElement = "TrafficAction";

    SourceLine source;
    std::string name; ///< trafficName; may be empty
    std::variant<TrafficSource, TrafficSink, TrafficSwarm, TrafficArea, TrafficStop> content;

    bool operator==(const TrafficAction&) const = default;
};

} // namespace simulation
