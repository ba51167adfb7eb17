// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "simulation/contact/ObstacleMap.h"
#include "simulation/control/ControlSwitch.h"
#include "simulation/control/InputTrack.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/player/Seat.h"
#include "simulation/vehicle/EarthFrame.h"
#include "simulation/vehicle/Ground.h"

namespace simulation
{

struct Scenario;

/// Who sits where in a scenario, and what moves. Empty paths: none.
struct SeatSettings
{
    std::string entity;
    bool isTakenAtStart = false;     ///< else when somebody takes over, or the storyboard asks
    std::filesystem::path vehicle{}; ///< its data file; empty: by the entity's category
    std::filesystem::path inputs{};  ///< recorded ones, in place of a person's
    bool isRecorded = false;         ///< what is done is kept for recorded()
    std::uint64_t seed = 0;          ///< of turbulence
};

/// Lets a person, or what one has recorded, drive an entity of a scenario with a vehicle of its own physics.
///
/// Inputs count the steps, or the seconds, of the play. Their column `person` says who has the entity: 1 the
/// person, 0 the scenario; without it the person has it from the start, or as the storyboard asks. A vehicle
/// that is no longer sound is not given back.
/// Determinism: the same settings and the same calls between the same steps give the same bytes. Threads:
/// one.
class PersonSeat final : public Seat
{
public:
    /// What the vehicle meets. Null ground: create() is used to check settings alone.
    struct World
    {
        std::shared_ptr<const Ground> ground;
        std::optional<Geodetic> origin;
        std::shared_ptr<const ObstacleMap> obstacles = nullptr; ///< null: nothing stands there
    };

    /// Errors: an entity that is neither a vehicle nor an aircraft, the files of the settings, inputs that
    /// the vehicle has not.
    static foundation::Result<std::shared_ptr<PersonSeat>> create(SeatSettings settings,
                                                                  const ScenarioObject& object, World world);

    /// The person takes over, or gives back: from the next step on. Over recorded inputs the person gives
    /// back to those. Returns why that cannot be; empty: it can.
    std::string giveToPerson(bool isByHand);

    /// Whether hands move it now.
    bool isByHand() const { return _motion && _controls->isByHand(); }

    /// Null: the scenario has the entity.
    const std::shared_ptr<VehicleMotion>& motion() const { return _motion; }
    ControlSwitch* controls() const { return _motion ? _controls : nullptr; }

    /// A vehicle of the same kind, for what its instruments look like.
    const DynamicVehicle& model() const { return *_model; }
    const std::string& entity() const { return _settings.entity; }
    bool isAirborne() const { return _isAirborne; }

    /// Why the last take-over failed; empty: it did not.
    const std::string& refusal() const { return _refusal; }

    /// What was done up to a time of the play, as an inputs file that repeats it. Units: seconds.
    InputTrack recorded(double timeS) const;

    // Seat
    void ask(bool isTaken) override;
    bool isWanted(double timeS) const override;
    foundation::Result<std::shared_ptr<ExternalMotion>> take(const ScenarioObject& object,
                                                             const MotionStart& start) override;
    void leave(double timeS) override;
    void refuse(const foundation::Error& error) override;
    bool isDone(double timeS) const override;

private:
    PersonSeat(SeatSettings settings, World world) : _settings(std::move(settings)), _world(std::move(world))
    {
    }
    foundation::Outcome readInputsFile();
    double placeOf(double timeS) const;
    std::int64_t stepAt(double timeS) const;
    foundation::Result<std::unique_ptr<DynamicVehicle>> makeVehicle() const;
    foundation::Result<std::unique_ptr<VehicleController>> makeControls(const DynamicVehicle& vehicle,
                                                                        std::int64_t firstStep) const;
    void addRows(InputTrack& track) const;

    SeatSettings _settings;
    World _world;
    bool _isAirborne = false;
    std::unique_ptr<DynamicVehicle> _model;
    std::optional<InputTrack> _inputs; ///< without the column person
    std::optional<InputTrack> _person; ///< that column alone
    bool _isAsked = false;             ///< by the start or the storyboard
    bool _hasHand = false;             ///< the person has taken over by itself
    std::string _refusal;
    std::shared_ptr<VehicleMotion> _motion;
    ControlSwitch* _controls = nullptr; ///< of the motion
    std::int64_t _firstStep = 0;        ///< of the play, at which the motion began
    InputTrack _record;                 ///< of the motions before
};

/// The entity of that name in which somebody may sit. Errors: there is none, or it is neither a vehicle nor
/// an aircraft; the error lists those that are.
foundation::Result<std::size_t> seatIn(const Scenario& scenario, const std::string& entity);

/// The first entity that a manual controller of the scenario has; nothing: none.
std::optional<std::size_t> manualEntity(const Scenario& scenario);

} // namespace simulation
