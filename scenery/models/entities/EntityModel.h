// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "scenery/models/Model.h"
#include "scenery/models/entities/EntityShape.h"

namespace scenery::models
{

/// Where the moving parts of an aircraft are. Trailing edges: down, that of the rudder to the left. Units:
/// radians, rad/s, metres.
struct AircraftMotion
{
    double elevatorRad = 0.0, leftAileronRad = 0.0, rightAileronRad = 0.0, rudderRad = 0.0, flapRad = 0.0;
    double rotorTurnRad = 0.0; ///< of the propeller, or of a helicopter's main rotor, in its sense of turning
    double rotorRadps = 0.0;
    double noseSteeringRad = 0.0; ///< to the left

    struct Leg
    {
        glm::dvec3 bottom{0.0}; ///< of its wheel with the strut unloaded; entity's frame
        double strutM = 0.0;    ///< pressed in
        double turnRad = 0.0;   ///< of the wheel, forward
    };
    std::optional<std::array<Leg, 3>> legs; ///< nose, left, right; nothing: as the model has them
};

/// How an entity moves, as far as its parts show it. Units: metres, m/s, radians.
struct EntityMotion
{
    double odometerM = 0.0; ///< distance covered
    double speedMps = 0.0;
    double steeringRad = 0.0;             ///< of the front wheels, to the left
    std::array<double, 4> wheelTravelM{}; ///< front left, front right, rear left, rear right; upwards

    /// How far each wheel has turned, in the same order; nothing: they roll with the odometer.
    std::optional<std::array<double, 4>> wheelTurnRad{};
    AircraftMotion aircraft{};
};

/// A lamp of a vehicle.
struct EntityLamp
{
    enum class Kind
    {
        head,
        tail,
        brake,
        indicatorLeft,
        indicatorRight,
        reversing,
        warning,         ///< blue lights
        navigationRed,   ///< of an aircraft's left wing tip
        navigationGreen, ///< of its right one
        navigationWhite, ///< of its tail
        strobe,
        beacon,
        landing,
        count,
    };
    Kind kind = Kind::head;
    glm::dvec3 middle{0.0}; ///< in the entity's frame
    bool looksAhead = true; ///< else backwards
    double widthM = 0.2, heightM = 0.1;
    double sweepM = 0.0;   ///< how far the end on its left lies farther ahead than that on its right
    double asideRad = 0.0; ///< how far to the left of straight ahead (or back) the middle of its light goes
    double halfAngleRad = 1.4; ///< from there to the edge of its light; above pi: it shines all around
};

/// Which lamps shine, by EntityLamp::Kind.
using LitLamps = std::array<bool, static_cast<std::size_t>(EntityLamp::Kind::count)>;

/// A propeller or rotor. Frame: the entity's.
struct EntityRotor
{
    glm::dvec3 hub{0.0}, axis{1.0, 0.0, 0.0};
    double radiusM = 1.0, hubRadiusM = 0.12;
    double turns = 1.0;     ///< while the first rotor turns once
    std::size_t blades = 0; ///< the part that a disc replaces while it turns fast
};

/// A generated entity: rigid parts, what places them, and where its lamps are.
/// Frame of the parts: their own; `pose` returns for each part the matrix to the entity's frame.
/// Invariant: pose() is pure, and returns as many matrices as there are parts.
struct EntityModel
{
    std::vector<Model> meshes;
    std::vector<std::size_t> parts; ///< the mesh of each part
    std::vector<std::string> names; ///< of the parts that have one, by their index; may be shorter
    std::function<std::vector<glm::dmat4>(const EntityMotion&)> pose;
    std::vector<EntityLamp> lamps;
    std::vector<EntityRotor> rotors;
    glm::dvec3 eye{0.0}; ///< of its driver or rider
    double shadowMiddleXM = 0.0, shadowHalfLengthM = 0.5,
           shadowHalfWidthM = 0.3; ///< of the soft one; length 0: none

    std::size_t addMesh(Model mesh)
    {
        meshes.push_back(std::move(mesh));
        return meshes.size() - 1;
    }
};

/// Generates the model of an entity. Pure. Precondition: isPlausible() of DefaultSize.h. Axles that are
/// missing are added, and wheels that are too large for the body are made smaller. Cost: 1 to 20 ms.
EntityModel makeEntityModel(EntityShape shape);

} // namespace scenery::models
