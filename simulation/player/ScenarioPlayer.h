// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "simulation/clock/FixedClock.h"
#include "simulation/player/MotionSource.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/player/Seat.h"
#include "simulation/player/StoryboardElements.h"
#include "simulation/road/RoadScene.h"
#include "simulation/scenario/Scenario.h"
#include "simulation/state/EntityState.h"
#include "simulation/state/EntityTold.h"
#include "simulation/state/EnvironmentState.h"

namespace simulation
{

struct PlayerOptions
{
    std::optional<Geodetic> origin; ///< of the scene; absent: no georeference
    GroundProvider ground;          ///< may be empty: positions are used as the scenario gives them
    MapProjection projection{};     ///< of the roads, where there is no origin; may be empty
    FixedClock clock = FixedClock(120);
    std::string scenarioName = "scenario";    ///< replaces the file in errors: scenarioName:line
    std::shared_ptr<const RoadScene> roads{}; ///< of the LogicFile; null: positions on roads are not placed

    /// The roads of a world on which entities are not placed: states tell the lane under them. Where `roads`
    /// are given, those count. May be null.
    std::shared_ptr<const RoadScene> roadsUnder{};

    /// What moves entities in place of their actions, by name; Init tells where they begin.
    std::map<std::string, std::shared_ptr<ExternalMotion>> motions{};

    /// Where persons may sit, by entity; see Seat.
    std::map<std::string, std::shared_ptr<Seat>> seats{};

    /// Makes the vehicles with physics that controllers of entities drive; null: the scenario moves those
    /// entities.
    std::shared_ptr<MotionSource> motionSource{};

    std::uint64_t seed = 0; ///< of what is left to chance: traffic and random routes
    WorldAir air{};         ///< of the world; what the scenario says goes before it
};

/// Plays a scenario in fixed steps. Its states depend on the scenario, the options and the number of steps
/// only: two runs agree to the last bit. After create() the states are those of time 0, after the Init
/// actions. In one step the clock advances, then the actions go on, entities move, then triggers are
/// evaluated and actions start (their motion begins with the next step). On a road network the states are
/// those before the triggers, and entities move as in esmini (decision 30).
/// Frame: the scene's east-north-up. Threads: one player, one thread; players are independent.
/// Source: ASAM, *OpenSCENARIO XML* 1.3; see also PathCurve, EntityMotion, StoryboardRunner.
class ScenarioPlayer
{
public:
    /// Errors, with the line of the element: a place on a road without a road network, a GeoPosition without
    /// an origin, an unknown entity, a trajectory that cannot be run, a motion of no entity or that cannot
    /// begin. Unsupported content of a tolerant reading is skipped: such an action ends at once, such a
    /// condition is never true, such an entity stands at the origin. The same goes for references to a road,
    /// a lane or a storyboard element that is not there: see warnings().
    static foundation::Result<std::unique_ptr<ScenarioPlayer>> create(Scenario scenario,
                                                                      PlayerOptions options);

    ~ScenarioPlayer();
    ScenarioPlayer(const ScenarioPlayer&) = delete;
    ScenarioPlayer& operator=(const ScenarioPlayer&) = delete;

    /// Does nothing once isFinished().
    void step();

    double timeS() const;
    const FixedClock& clock() const;
    const Scenario& scenario() const;

    /// In the order of Scenario::entities.
    const std::vector<EntityState>& entities() const;
    const EnvironmentState& environment() const;

    /// The states of traffic signals that actions have set, by the signal's id, in the file's words.
    const std::map<std::string, std::string>& signalStates() const;
    const std::vector<StoryboardLogEntry>& log() const;
    const std::map<std::string, bool>& monitors() const; ///< by name
    bool isFinished() const;

    /// What a person should know of vehicles with physics: a crash, a controller that could not begin. A line
    /// each.
    std::vector<std::string> notes() const;

    /// What refers to something that is not there, with the line of the element and what is done instead.
    const std::vector<foundation::Error>& warnings() const;

    /// Whether there are motions that were lent, and all are done; or the recorded inputs of a person have
    /// ended.
    bool areMotionsDone() const;

    /// In the order of entities(); empty: nobody may sit anywhere.
    const std::vector<EntityTold>& told() const;

private:
    ScenarioPlayer(Scenario scenario, PlayerOptions options);

    class Stage;
    std::unique_ptr<Stage> _stage;
};

} // namespace simulation
