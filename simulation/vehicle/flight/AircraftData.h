// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "simulation/vehicle/Hull.h"
#include "simulation/vehicle/Table.h"

namespace simulation
{

/// All that is known of one type of aircraft, as its data file has it (docs/reference/aircraft-file.md).
/// Frame of places: the structural one, x aft, y right, z up, about any datum. Units: SI; degrees where the
/// name says so.

/// What a coefficient may depend on.
enum class Argument
{
    none,
    alphaDeg,
    betaDeg,
    flapDeg,
    stalled, ///< 0 attached flow … 1 separated
    heightOverSpan,
    count
};

inline constexpr std::array<std::string_view, static_cast<std::size_t>(Argument::count)> kArgumentNames{
    "none", "alphaDeg", "betaDeg", "flapDeg", "stalled", "heightOverSpan"};

/// The parts of forces and moments. Each is multiplied by what its name says: angles in radians; rates as
/// p·b/2V, q·c/2V, r·b/2V and α̇·c/2V. Drag of elevator and sideslip goes by the angle's amount.
enum class Part
{
    lift,
    liftFlap,
    liftElevator,
    liftAlphaRate,
    liftPitchRate,
    liftGround, ///< factor of lift near the ground
    drag,
    dragAlpha,
    dragFlap,
    dragElevator,
    dragSideslip,
    dragGround, ///< factor of dragAlpha and dragFlap near the ground
    side,       ///< over betaDeg, not multiplied by it
    sideAileron,
    sideRudder,
    sideRollRate,
    sideYawRate,
    roll, ///< over betaDeg
    rollAileron,
    rollRudder,
    rollRollRate,
    rollYawRate,
    pitch,
    pitchAlpha,
    pitchFlap,
    pitchElevator, ///< in the slipstream
    pitchAlphaRate,
    pitchPitchRate,
    yaw, ///< over betaDeg
    yawAileron,
    yawRudder, ///< in the slipstream
    yawRollRate,
    yawYawRate,
    count
};

inline constexpr std::array<std::string_view, static_cast<std::size_t>(Part::count)> kPartNames{
    "lift",        "liftFlap",      "liftElevator",   "liftAlphaRate",  "liftPitchRate", "liftGround",
    "drag",        "dragAlpha",     "dragFlap",       "dragElevator",   "dragSideslip",  "dragGround",
    "side",        "sideAileron",   "sideRudder",     "sideRollRate",   "sideYawRate",   "roll",
    "rollAileron", "rollRudder",    "rollRollRate",   "rollYawRate",    "pitch",         "pitchAlpha",
    "pitchFlap",   "pitchElevator", "pitchAlphaRate", "pitchPitchRate", "yaw",           "yawAileron",
    "yawRudder",   "yawRollRate",   "yawYawRate"};

/// One coefficient: a table over up to two arguments. A part that the file leaves out is 0; a ground factor
/// is 1.
struct CoefficientTable
{
    Argument row = Argument::none;
    Argument column = Argument::none;
    Table table;
};

/// A load, a tank's contents or the empty aircraft.
struct MassPoint
{
    std::string name;
    double massKg = 0.0;
    glm::dvec3 place{0.0};
};

struct FuelTank
{
    std::string name;
    double capacityKg = 0.0;
    double contentsKg = 0.0; ///< at the start
    glm::dvec3 place{0.0};
};

/// The travel of a control surface: degrees at the commands -1 and +1, straight between each and 0.
struct SurfaceTravel
{
    double negativeDeg = 0.0;
    double positiveDeg = 0.0;

    double degreesAt(double command) const
    {
        return command < 0.0 ? -command * negativeDeg : command * positiveDeg;
    }
};

struct FlapData
{
    double fullDeg = 0.0;
    double rateDegPerS = 0.0;
};

/// Separated flow: where it begins and ends, and what a wing across the wind is worth.
struct StallData
{
    double beginsDeg = 90.0;  ///< angle of attack at which the flow separates
    double endsDeg = 0.0;     ///< at which it attaches again
    double plateNormal = 0.0; ///< coefficient of the force across the wing at 90°
    double plateSide = 0.0;   ///< side force at 90° of sideslip
    double platePitch = 0.0;  ///< pitching moment at 90°, nose down
};

struct EngineData
{
    double displacementM3 = 0.0;
    double volumetricEfficiency = 0.0;
    double residualShare = 0.0; ///< of the ambient pressure: exhaust gas that stays in the cylinder
    double intakeLoss = 0.0;    ///< s: pressure loss over pressure per turn a second, throttle open
    double throttleLoss = 0.0;  ///< s: more of it with the square of the closed share
    double idleOpening = 0.0;   ///< of the throttle at the command 0
    double manifoldLagS = 0.0;
    double fullRichness = 0.0; ///< fuel over stoichiometric at the sea, mixture 1
    double heatingValueJPerKg = 0.0;
    Table efficiency;            ///< indicated, over richness
    double frictionNm = 0.0;     ///< of the turning engine
    double frictionNms = 0.0;    ///< more with the speed in rad/s
    double pumpingNmPerPa = 0.0; ///< more with the suction in the manifold
    double starterNm = 0.0;
    double stopRadps = 0.0; ///< below it nothing ignites
};

struct PropellerData
{
    double diameterM = 0.0;
    double inertiaKgM2 = 0.0;
    double turnsRight = 1.0;       ///< 1 seen from behind, -1 left
    double discShiftMPerRad = 0.0; ///< of the thrust's point over the angle of the inflow
    double gyroscopicFactor = 1.0; ///< of its gyroscopic moment; not in files, for comparisons alone
    glm::dvec3 place{0.0};
    Table thrust; ///< coefficient over advance ratio
    Table power;

    /// Angular momentum about the body's x axis that the body feels. Units: kg m²/s.
    double spin(double speedRadps) const { return gyroscopicFactor * turnsRight * inertiaKgM2 * speedRadps; }
};

enum class Brake
{
    none,
    left,
    right
};

/// A point that can touch the ground: a wheel on its strut, or a part of the structure.
struct ContactData
{
    std::string name;
    bool isWheel = false;
    glm::dvec3 place{0.0}; ///< unloaded
    double springNPerM = 0.0;
    double dampingNsPerM = 0.0;
    double friction = 0.8;        ///< on dry asphalt, sideways and braked
    double radiusM = 0.2;         ///< of a wheel
    double corneringPerRad = 8.0; ///< of a wheel: force sideways over load and slip angle
    double steeringDeg = 0.0;
    Brake brake = Brake::none;
    double strongestMps = 0.0; ///< vertical speed at which it breaks
};

struct AircraftData
{
    std::string name;
    double wingAreaM2 = 0.0, wingSpanM = 0.0, meanChordM = 0.0;
    glm::dvec3 aerodynamicPoint{0.0}; ///< about which the moments are given
    MassPoint empty;
    glm::dmat3 emptyInertia{0.0}; ///< kg m², about the empty centre of mass, axes forward, right, down
    std::vector<MassPoint> loads;
    std::vector<FuelTank> tanks;
    SurfaceTravel elevator, aileron, rudder;
    FlapData flaps;
    StallData stall;
    std::array<CoefficientTable, static_cast<std::size_t>(Part::count)> coefficients;
    EngineData engine;
    PropellerData propeller;
    std::vector<ContactData> contacts;
    HullData hull; ///< about the datum of the structural frame, axes forward, left, up

    const CoefficientTable& coefficient(Part part) const
    {
        return coefficients[static_cast<std::size_t>(part)];
    }
};

} // namespace simulation
