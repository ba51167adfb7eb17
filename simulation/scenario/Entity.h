// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "simulation/scenario/SourceLine.h"

namespace simulation
{

/// Frame: the entity's: x forward, y left, z up, about its reference point (for a vehicle the rear axle's
/// middle on the ground). Units: metres.
struct BoundingBox
{
    glm::dvec3 centre{0.0};
    double lengthM = 0.0;
    double widthM = 0.0;
    double heightM = 0.0;

    bool operator==(const BoundingBox&) const = default;
};

struct Axle
{
    double maxSteeringRad = 0.0;
    double wheelDiameterM = 0.0;
    double trackWidthM = 0.0;
    double positionXM = 0.0;
    double positionZM = 0.0;

    bool operator==(const Axle&) const = default;
};

struct Performance
{
    double maxSpeedMps = 0.0;
    double maxAccelerationMps2 = 0.0;
    double maxDecelerationMps2 = 0.0;

    bool operator==(const Performance&) const = default;
};

struct Properties
{
    std::vector<std::pair<std::string, std::string>> values; ///< in the file's order
    std::vector<std::string> files;

    bool operator==(const Properties&) const = default;
    std::optional<std::string> find(const std::string& name) const;
};

struct Vehicle
{
    SourceLine source;
    std::string name;
    std::string category; ///< the standard's, and here also `aircraft` and `helicopter`
    std::string model3d;
    std::optional<double> massKg;
    BoundingBox box;
    Performance performance;
    std::optional<Axle> frontAxle;
    Axle rearAxle;
    std::vector<Axle> additionalAxles;
    std::optional<double> trailerHitchDxM;
    std::optional<double> trailerCouplerDxM;
    std::string trailerEntity; ///< the entity that is towed; empty: none
    Properties properties;

    bool operator==(const Vehicle&) const = default;
};

struct Pedestrian
{
    SourceLine source;
    std::string name;
    std::string category; ///< pedestrian, wheelchair, animal
    std::string model3d;
    double massKg = 0.0;
    BoundingBox box;
    Properties properties;

    bool operator==(const Pedestrian&) const = default;
};

struct MiscObject
{
    SourceLine source;
    std::string name;
    std::string category;
    std::string model3d;
    double massKg = 0.0;
    BoundingBox box;
    Properties properties;

    bool operator==(const MiscObject&) const = default;
};

struct ControllerKind;

/// What drives an entity in place of the scenario, once it is activated.
struct Controller
{
    SourceLine source;
    std::string name;
    Properties properties;
    std::string
        objectName{}; ///< of the ObjectController that it stands in (1.3), by which actions name it, too

    bool operator==(const Controller&) const = default;

    /// What drives: the property `kind`, else esminiController (ACCController, InteractiveController …), else
    /// the name.
    std::string kind() const
    {
        if (const auto kind = properties.find("kind")) return *kind;
        return properties.find("esminiController").value_or(name);
    }

    /// By which it is played; null: by nothing, and the actions of the scenario move the entity.
    const ControllerKind* played() const;

    /// Whether it moves a vehicle with physics.
    bool hasPhysics() const;

    /// Whether it gives the entity to a person who sits in it.
    bool isManual() const;

    /// Returns a property as a number, or `fallback`.
    double number(const std::string& property, double fallback) const;
};

struct ScenarioObject
{
    SourceLine source;
    std::string name;
    std::variant<Vehicle, Pedestrian, MiscObject, Unsupported> object;
    std::vector<Controller> controllers{};

    bool operator==(const ScenarioObject&) const = default;
    const BoundingBox& box() const;
    const Properties& properties() const;
    const std::string& model3d() const;

    /// Returns true for an entity that does not stand on the ground: a vehicle of category `aircraft` or
    /// `helicopter`, or an object with the property `domain` = `air` (the form that the schema of the
    /// standard accepts).
    bool isAirborne() const;
};

} // namespace simulation
