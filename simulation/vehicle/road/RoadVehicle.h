// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "simulation/vehicle/DynamicVehicle.h"
#include "simulation/vehicle/EarthFrame.h"
#include "simulation/vehicle/road/BodyWorld.h"
#include "simulation/vehicle/road/Drivetrain.h"
#include "simulation/vehicle/road/HullMeeting.h"
#include "simulation/vehicle/road/RoadInputs.h"
#include "simulation/vehicle/road/RoadVehicleData.h"
#include "simulation/vehicle/road/WheelGround.h"

namespace simulation
{

/// A wheel during a step. Units: metres, N, rad/s.
struct RoadWheel
{
    double steerRad = 0.0;
    double travelM = 0.0, travelMps = 0.0; ///< of the hub in the body, upwards from where it rests
    double radps = 0.0, rotationRad = 0.0; ///< forward
    double loadN = 0.0;                    ///< across the ground
    glm::dvec2 forceN{0.0};                ///< along the wheel and to its left
    glm::dvec2 bend{0.0};                  ///< of the tyre
    double contactRadiusM = 0.0;           ///< that it rolls with
    double brakeShare = 1.0;               ///< that the ABS lets through
    double slip = 0.0;                     ///< along, over the speed
    double tyreSlip = 0.0;                 ///< over that at which friction peaks
    WheelContact contact;
    WheelGround ground;

    bool isTouching() const { return loadN > 0.0; }
};

/// Where a vehicle begins: its reference point (on the ground below the middle of the rear axle), heading
/// from x towards y, speed.
struct RoadStart
{
    glm::dvec3 position{0.0}; ///< of surfaces over each other, the one at this height
    double headingRad = 0.0;
    double speedMps = 0.0;
};

/// What a driver's instruments and a log say.
struct RoadReadings
{
    double speedMps = 0.0;            ///< forward
    glm::dvec3 accelerationMps2{0.0}; ///< body axes, without gravity, over the last step
    double yawRateRadps = 0.0;
    double steeringWheelDeg = 0.0;
    double engineRpm = 0.0;
    int gear = 0;
};

/// A road vehicle that drives by its data file, at 120 steps a second; eight shorter ones in each for tyres,
/// wheels and the body.
///
/// The body is a rigid body of Bullet; its hull meets the ground and other bodies of its BodyWorld. Wheels
/// move up and down in the body and turn; their tyres stand on `Ground`. Numbers that leave what can be
/// computed end in VehicleCondition::failed, never in NaN. A wheel's mass counts with the body; its hop is
/// that of its mass between tyre and spring.
/// Source: Rill, *Road Vehicle Dynamics*, 2011, chapters 3 to 8 (load transfer, suspension, drive); Pacejka
/// as in Tyre.h.
/// Cost: see docs/algorithms/driving.md.
class RoadVehicle : public DynamicVehicle
{
public:
    /// `earth`: null for a scene without a place on the Earth. `world`: null for a vehicle that meets no
    /// other.
    explicit RoadVehicle(std::shared_ptr<const RoadVehicleData> data,
                         std::shared_ptr<const EarthFrame> earth = nullptr,
                         std::shared_ptr<BodyWorld> world = nullptr);

    std::span<const std::string_view> inputNames() const override { return kRoadInputNames; }
    std::span<double> inputs() override { return _inputs; }
    RoadInputs& roadInputs() { return _inputs; }
    const RoadInputs& roadInputs() const { return _inputs; }
    double stepSeconds() const override { return kStepS; }
    void step(const Ground& ground, const Air& air) override;
    foundation::Outcome begin(const VehicleStart& start, const Ground& ground, const Air& air) override;
    glm::dvec3 referencePoint() const override { return -_mass.centre; }
    void writeParts(EntityState& entity) const override;
    VehicleState state() const override;
    VehicleStatus status() const override { return _status; }
    void meet(std::shared_ptr<const ObstacleMap> obstacles) override
    {
        _meeting.obstacles().meet(std::move(obstacles));
    }
    void meetMovers(std::span<const MovingObstacle> movers) override
    {
        _meeting.obstacles().meetMovers(movers);
    }
    std::span<const int> touchedMovers() const override { return _meeting.touchedMovers(); }
    std::span<const Impact> impacts() const override { return _meeting.obstacles().impacts(); }

    /// Steps vehicles that share a world.
    static void stepTogether(std::span<RoadVehicle* const> vehicles, const Ground& ground, const Air& air);

    /// Puts the vehicle onto the ground, rolling without slip. A start that is not finite or without ground
    /// is refused, and the status says so.
    void place(const RoadStart& start, const Ground& ground, double timeS = 0.0);

    const RoadVehicleData& data() const { return *_data; }
    const RoadMassProperties& mass() const { return _mass; }
    std::span<const RoadWheel, 4> wheels() const
    {
        return _wheels;
    } ///< front left, front right, rear left, rear right
    RoadReadings readings() const;

    /// Kinetic and potential energy, of turning wheels too, over the scene's height 0. Units: J.
    double energyJ() const;

    static constexpr double kStepS = 1.0 / 120.0;
    static constexpr int kSubsteps = 8;

private:
    struct Axes
    {
        glm::dvec3 forward, left, up;
    };

    Axes axes() const;
    glm::dvec3 hubOf(std::size_t wheel) const;
    void prepare(const Ground& ground, const Air& air);
    void press(double stepS);
    void end(double stepS);
    void finish();
    void steer();
    void lookAtGround(const Ground& ground);
    void liftOutOfGround();
    void lookAtWater(const Ground& ground, bool hasWater);
    void swim(double stepS);
    void lookAtObstacles();
    glm::dvec3 airForce(const Air& air) const;
    double springForce(std::size_t wheel) const;
    void pressWheel(std::size_t wheel, double driveNm, double stepS);
    void spin(std::size_t wheel, double driveNm, double rollingMps, double stepS);
    void antiLock(RoadWheel& wheel, double wheelBrakeNm, double rollingMps, double stepS) const;
    double shaftRadps() const;
    bool isComputable() const;
    void writeLamps(EntityState& entity) const;
    void crash(std::string_view reason);
    void fail(std::string_view reason);

    std::shared_ptr<const RoadVehicleData> _data;
    std::shared_ptr<const EarthFrame> _earth;
    std::shared_ptr<BodyWorld> _world;
    RoadMassProperties _mass;
    int _body = 0;
    HullMeeting _meeting;
    std::array<double, 2> _restN{};
    std::array<double, 2> _hubZM{}; ///< at rest, above the reference point
    RoadInputs _inputs{};
    Drivetrain _drivetrain;
    std::array<RoadWheel, 4> _wheels;
    SolidMotion _motion, _before;
    glm::dvec3 _gravity{0.0}, _airForce{0.0}, _acceleration{0.0};
    double _steerRad = 0.0, _brakeNm = 0.0;
    double _overS = 0.0; ///< how long it has lain on its side
    double _timeS = 0.0, _startS = 0.0;
    std::int64_t _step = 0;
    VehicleStatus _status;
    std::optional<double> _waterM; ///< level of the water around it
    double _airShare = 1.0;        ///< of the hull that water has not filled
};

} // namespace simulation
