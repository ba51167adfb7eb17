// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "simulation/vehicle/EarthFrame.h"
#include "simulation/vehicle/flight/DrydenTurbulence.h"
#include "simulation/vehicle/flight/FlightInputs.h"
#include "simulation/vehicle/jsbsim/JsbsimFrame.h"
#include "simulation/vehicle/jsbsim/JsbsimProcess.h"

namespace simulation
{

/// An aircraft that JSBSim flies, in a process of its own, at 120 steps a second.
///
/// Its inputs are those of FlightInputs and then those of its data. Before each step JSBSim gets the inputs
/// that have changed, the wind, the turbulence and the height of the ground below the centre of mass: one
/// height, level; it asks for none below each wheel. Its atmosphere, gravity and sea are its own.
///
/// A JSBSim that hangs, ends, answers nonsense, leaps or whose numbers are no numbers ends in
/// VehicleCondition::failed: it is killed and the aircraft stands still at its last good state. One that
/// touches the ground with more than its wheels at more than 5 m/s, or comes down on water, has crashed and
/// goes on without power.
/// Determinism: the same inputs, ground and air give the same bytes, as JSBSim does. Source:
/// docs/decisions/0036-jsbsim-as-a-process.md.
class JsbsimVehicle final : public DynamicVehicle
{
public:
    /// `seed`: of the turbulence. JSBSim is started by begin().
    JsbsimVehicle(std::shared_ptr<const JsbsimData> data, std::shared_ptr<const EarthFrame> earth,
                  std::uint64_t seed = 0);

    std::span<const std::string_view> inputNames() const override { return _names; }
    std::span<double> inputs() override { return _inputs; }
    double stepSeconds() const override { return kStepS; }
    void step(const Ground& ground, const Air& air) override;

    /// In the air JSBSim is told to find a steady flight; where it finds none, the aircraft begins level, and
    /// note() says so. On the ground it is let down onto its wheels, brakes set, and then rolls. Errors:
    /// besides those of checkFlyingStart() and checkStandingStart() those of JsbsimProcess.
    foundation::Outcome begin(const VehicleStart& start, const Ground& ground, const Air& air) override;
    glm::dvec3 referencePoint() const override { return _reference; }
    void writeParts(EntityState& entity) const override;
    VehicleState state() const override { return _state; }
    VehicleStatus status() const override { return _status; }

    /// What a person should know of the begin; empty: nothing.
    const std::string& note() const { return _note; }

    /// Of the process, for tests; -1: none runs.
    pid_t processId() const { return _process ? _process->id() : -1; }

    static constexpr double kStepS = 1.0 / JsbsimProcess::kStepsPerSecond;

private:
    /// A property of JSBSim that an input sets: the input times a factor.
    struct Link
    {
        std::size_t input;
        double factor;
        std::string property;
        double sent = 0.0;
    };

    /// A point that may touch the ground, from the centre of mass. Frame: body, x forward, y left, z up.
    struct Foot
    {
        glm::dvec3 place{0.0};
        bool isWheel = false;
    };

    foundation::Outcome beginInAir(const VehicleStart& start, const GroundPoint& below, const Air& air);
    foundation::Outcome beginOnGround(const VehicleStart& start, const GroundPoint& below);
    foundation::Outcome examine(JsbsimStart start);
    void examineFeet();
    void findReference();
    void linkInputs();
    void takeInputs();
    void enter(const glm::dvec3& position);
    JsbsimStart startAt(const VehicleStart& start, const glm::dvec3& position, double groundM) const;
    std::string orders(const Ground& ground, const Air& air);
    void take(const Ground& ground);
    void judgeContacts();
    void fail(JsbsimFault fault);
    void fail(std::string_view reason);

    std::shared_ptr<const JsbsimData> _data;
    std::shared_ptr<const EarthFrame> _earth;
    std::uint64_t _seed;
    std::vector<std::string_view> _names;
    std::vector<double> _inputs;
    std::unique_ptr<JsbsimProcess> _process;
    std::optional<JsbsimFrame> _frame;
    std::vector<Link> _links;
    std::vector<std::pair<std::string, double>>
        _settings; ///< of a running engine, those that the aircraft has
    std::vector<Foot> _feet;
    glm::dvec3 _reference{0.0};
    double _wingSpanM = 10.0;
    bool _hasWind = false;
    glm::dvec3 _sentWind{0.0};
    double _sentTerrainM = 0.0;
    GroundPoint _below;
    AirSample _aroundIt; ///< at the last step, gusts within its wind
    DrydenTurbulence _turbulence;
    JsbsimRow _row; ///< the last good one
    std::int64_t _step = 0;
    double _propellerDeg = 0.0, _wheelDeg = 0.0;
    VehicleState _state;
    VehicleStatus _status;
    std::string _note;
};

} // namespace simulation
