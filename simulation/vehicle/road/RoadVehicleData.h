// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "simulation/vehicle/Hull.h"
#include "simulation/vehicle/Table.h"

namespace simulation
{

/// All that is known of one type of road vehicle, as its data file has it
/// (docs/reference/road-vehicle-file.md).
/// Frame of places: x forward, y left, z up, about the point on the ground below the middle of the rear axle,
/// as the vehicle stands with its loads. Units: SI; degrees and 1/min where the name says so.

/// A part of the vehicle or of its load.
struct RoadMass
{
    std::string name;
    double massKg = 0.0;
    glm::dvec3 place{0.0};
    glm::dvec3 inertiaKgM2{0.0}; ///< about its own centre: roll, pitch, yaw; a load is a point
};

/// Areas are those of drag coefficients times frontal area, and so on.
struct BodyAirData
{
    double dragAreaM2 = 0.0, sideAreaM2 = 0.0;
};

/// A tyre. Stiffnesses and friction are those at the reference load; both fall with the load.
struct RoadTyreData
{
    double radiusM = 0.0, widthM = 0.0;
    double springNPerM = 0.0, dampingNsPerM = 0.0; ///< across the ground
    double referenceLoadN = 0.0;
    double frictionAlong = 0.0, frictionAcross = 0.0; ///< peak over load on dry asphalt
    double slidingShare = 1.0;                        ///< of the peak, far beyond it
    double frictionLoss = 0.0;    ///< share of the friction that is lost at twice the reference load
    double slipStiffness = 0.0;   ///< force over load and slip, at small slip
    double cornerStiffness = 0.0; ///< force over load and radian of slip angle, at small angles
    double stiffnessLoss = 0.0;   ///< as frictionLoss
    double relaxationAlongM = 0.0, relaxationAcrossM = 0.0;
    double rollingResistance = 0.0;
};

/// An axle with a wheel on each side.
struct AxleData
{
    double xM = 0.0, trackM = 0.0;
    double wheelInertiaKgM2 = 0.0;
    double unsprungKg = 0.0; ///< of one wheel with what moves with it
    int tyresPerSide = 1;
    double springNPerM = 0.0; ///< at the wheel
    double bumpNsPerM = 0.0, reboundNsPerM = 0.0;
    double antiRollNPerM = 0.0;         ///< force at each wheel over the difference of their travels
    double bumpM = 0.0, reboundM = 0.0; ///< free travel from where it stands
    double stopNPerM = 0.0;             ///< of the stops beyond
    double rollCentreM = 0.0;           ///< above the ground
    double steersShare = 0.0;           ///< of the steered angle: 1 front, 0 fixed, negative against it
    double driveShare = 0.0, brakeShare = 0.0, handbrakeShare = 0.0;
    RoadTyreData tyre;
};

struct SteeringData
{
    double lockDeg = 0.0;     ///< of the road wheels, their mean
    double ratio = 1.0;       ///< steering wheel over road wheels
    double rateDegPerS = 0.0; ///< most, of the steering wheel
};

struct RoadEngineData
{
    Table fullTorqueNm; ///< over 1/min
    Table dragTorqueNm; ///< over 1/min: what the turning engine takes without fuel
    double inertiaKgM2 = 0.0;
    double idleRpm = 0.0, limitRpm = 0.0, stallRpm = 0.0;
    double lagS = 0.0; ///< in which its torque follows the pedal
};

/// A hydrodynamic torque converter with a lock-up clutch.
struct ConverterData
{
    Table torqueFactor; ///< torque of the pump over its speed squared, Nm s²/rad², over the ratio of speeds
    Table torqueRatio;  ///< turbine over pump
    double lockupNm = 0.0; ///< 0: none
    double lockupFromGear = 2.0;
    double lockupRatio = 0.85; ///< of speeds, from which it closes
};

struct GearboxData
{
    bool isAutomatic = false;
    std::vector<double> ratios; ///< forward, first gear first
    double reverseRatio = 0.0;  ///< positive
    double finalRatio = 0.0;
    double efficiency = 1.0;
    double inertiaKgM2 = 0.0; ///< of what turns with its input
    double shiftS = 0.0;
    double clutchNm = 0.0; ///< of a manual gearbox: most that its clutch carries
    ConverterData converter;
    double upIdleRpm = 0.0, upFullRpm = 0.0, downIdleRpm = 0.0,
           downFullRpm = 0.0; ///< automatic: by the pedal
};

struct BrakeData
{
    double mostNm = 0.0; ///< of all wheels together
    double handbrakeNm = 0.0;
    double lagS = 0.0;
    double absSlip = 0.0; ///< over that at which friction peaks: there the ABS lets go; 0: none
    double absFromMps = 0.0;
};

/// What vehicles of the class reach on dry asphalt, and how far these figures reach: see
/// qualification/DriveChecks.h.
struct PerformanceData
{
    double toKmh = 0.0, accelerateS = 0.0, accelerateToleranceS = 0.0; ///< from a standstill
    double stopM = 0.0, stopToleranceM = 0.0;                          ///< from 100 km/h
    double lateral = 0.0, lateralTolerance = 0.0;                      ///< most steady acceleration, g
};

struct RoadVehicleData
{
    std::string name;
    std::filesystem::path lookFile; ///< of what it looks like; empty: by its size and mass
    RoadMass body;
    std::vector<RoadMass> loads;
    HullData hull;
    BodyAirData air;
    std::array<AxleData, 2> axles; ///< front, rear
    SteeringData steering;
    RoadEngineData engine;
    GearboxData gearbox;
    BrakeData brakes;
    PerformanceData performance;

    double wheelbaseM() const { return axles[0].xM - axles[1].xM; }
};

/// Mass, centre and principal inertia of a loaded vehicle. Products of inertia, small in vehicles that are
/// alike on both sides, are left out. Units: kg, m, kg m².
struct RoadMassProperties
{
    double massKg = 0.0;
    glm::dvec3 centre{0.0};
    glm::dvec3 inertiaKgM2{1.0};
};

RoadMassProperties massProperties(const RoadVehicleData& vehicle);

/// The load of one wheel of each axle at rest on level ground. Units: N. 0 or less: it would tip over.
std::array<double, 2> restLoads(const RoadVehicleData& vehicle);

} // namespace simulation
