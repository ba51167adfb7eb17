// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "simulation/scenario/Distance.h"
#include "simulation/scenario/Position.h"
#include "simulation/scenario/Rule.h"

// Conditions on what entities do. Source: ASAM OpenSCENARIO XML 1.3, EntityCondition. Units: metres, seconds.

namespace simulation
{

enum class Direction
{
    total, ///< none given
    longitudinal,
    lateral,
    vertical,
};

/// The time in which the triggering entity comes to where the other one is.
struct TimeHeadwayCondition
{
    static constexpr std::string_view kElement = "TimeHeadwayCondition";

    std::string entity;
    double seconds = 0.0;
    Rule rule = Rule::greaterThan;
    DistanceMeasure measure;

    bool operator==(const TimeHeadwayCondition&) const = default;
};

struct TimeToCollisionCondition
{
    static constexpr std::string_view kElement = "TimeToCollisionCondition";

    std::variant<std::string, Position> target; ///< an entity or a place
    double seconds = 0.0;
    Rule rule = Rule::greaterThan;
    DistanceMeasure measure;

    bool operator==(const TimeToCollisionCondition&) const = default;
};

/// The distance to an entity (RelativeDistanceCondition) or to a place (DistanceCondition).
struct DistanceCondition
{
    static constexpr std::string_view kElement = "DistanceCondition";

    std::variant<std::string, Position> target;
    double metres = 0.0;
    Rule rule = Rule::greaterThan;
    DistanceMeasure measure;

    bool operator==(const DistanceCondition&) const = default;
};

struct TraveledDistanceCondition
{
    static constexpr std::string_view kElement = "TraveledDistanceCondition";

    double metres = 0.0;

    bool operator==(const TraveledDistanceCondition&) const = default;
};

struct ReachPositionCondition
{
    static constexpr std::string_view kElement = "ReachPositionCondition";

    Position position;
    double toleranceM = 0.0;

    bool operator==(const ReachPositionCondition&) const = default;
};

/// A speed (`entity` empty), a difference of speeds, or an acceleration.
struct SpeedCondition
{
    static constexpr std::string_view kElement = "SpeedCondition";

    std::string entity; ///< RelativeSpeedCondition: triggering minus this one
    double value = 0.0;
    Rule rule = Rule::greaterThan;
    Direction direction = Direction::total;

    bool operator==(const SpeedCondition&) const = default;
};

struct AccelerationCondition
{
    static constexpr std::string_view kElement = "AccelerationCondition";

    double value = 0.0;
    Rule rule = Rule::greaterThan;
    Direction direction = Direction::total;

    bool operator==(const AccelerationCondition&) const = default;
};

/// Something that has been so for a time.
struct LastingCondition
{
    static constexpr std::string_view kElement = "StandStillCondition";

    enum class Kind
    {
        standStill,
        offroad,
        endOfRoad,
    };

    Kind kind = Kind::standStill;
    double seconds = 0.0;

    bool operator==(const LastingCondition&) const = default;
};

struct CollisionCondition
{
    static constexpr std::string_view kElement = "CollisionCondition";

    std::string entity; ///< empty: any entity of a type
    std::string type;   ///< pedestrian, vehicle, miscellaneous; empty: any

    bool operator==(const CollisionCondition&) const = default;
};

/// The heading, pitch or roll of an entity, or what it differs by from those of another one.
struct AngleCondition
{
    static constexpr std::string_view kElement = "AngleCondition";

    enum class Kind
    {
        heading,
        pitch,
        roll,
    };

    std::string entity; ///< RelativeAngleCondition: triggering minus this one; empty: AngleCondition
    Kind kind = Kind::heading;
    double angleRad = 0.0, toleranceRad = 0.0;
    DistanceFrame frame = DistanceFrame::world; ///< from which an absolute angle counts

    bool operator==(const AngleCondition&) const = default;
};

/// Whether lanes beside the triggering entity are free, before and behind it.
struct RelativeClearanceCondition
{
    static constexpr std::string_view kElement = "RelativeClearanceCondition";

    /// Lanes to the left of that of the triggering entity; nothing: without end.
    struct Lanes
    {
        std::optional<int> from, to;

        bool operator==(const Lanes&) const = default;
    };

    double forwardM = 0.0, backwardM = 0.0;
    bool isFreespace = false; ///< boxes count, not reference points
    bool hasOppositeLanes = false;
    std::vector<Lanes> lanes;          ///< none: all
    std::vector<std::string> entities; ///< none: all others

    bool operator==(const RelativeClearanceCondition&) const = default;
};

using EntityConditionContentKinds =
    std::variant<TimeHeadwayCondition, TimeToCollisionCondition, DistanceCondition, TraveledDistanceCondition,
                 ReachPositionCondition, SpeedCondition, AccelerationCondition, LastingCondition,
                 CollisionCondition, AngleCondition, RelativeClearanceCondition, Unsupported>;

/// What is asked of entities. Compiled once, as Position is.
struct EntityConditionContent : EntityConditionContentKinds
{
    using EntityConditionContentKinds::variant;

    EntityConditionContent();
    EntityConditionContent(const EntityConditionContent&);
    EntityConditionContent(EntityConditionContent&&) noexcept;
    EntityConditionContent& operator=(const EntityConditionContent&);
    EntityConditionContent& operator=(EntityConditionContent&&) noexcept;
    ~EntityConditionContent();

    bool operator==(const EntityConditionContent&) const;
};

struct EntityCondition
{
    static constexpr std::string_view kElement = "ByEntityCondition";

    bool isForAll = false; ///< of the triggering entities; else any
    std::vector<std::string> entities;
    EntityConditionContent content;

    bool operator==(const EntityCondition&) const = default;
};

} // namespace simulation
