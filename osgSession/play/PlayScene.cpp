// SPDX-License-Identifier: Apache-2.0
#include "PlayScene.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>

#include "scene/DriveWay.h"
#include "scene/PlaceOnGround.h"
#include "scene/RideRoads.h"
#include "scene/SceneRoads.h"
#include "simulation/control/scenario/ScenarioMotions.h"
#include "simulation/road/ScenarioRoads.h"
#include "view/ChannelRig.h"
#include "view/WatchedEntity.h"

namespace trainer
{

namespace
{

/// The limit of triangles where the command line names none: blocks with locked borders cannot do with fewer
/// than their borders have.
std::uint32_t defaultMaxTriangles(osgTerrainROAM::core::Method method)
{
    return method == osgTerrainROAM::core::Method::vipmLocked ? std::numeric_limits<std::uint32_t>::max()
                                                              : kDefaultMaxTriangles;
}

foundation::Outcome configure(osgTerrainROAM::RoamTerrain& terrain, const TerrainRequest& request)
{
    osgTerrainROAM::RoamDrawableSettings settings = terrain.settings();
    settings.method = request.method.value_or(settings.method);
    settings.errorTolerancePx = request.errorTolerancePx;
    settings.maxTriangles = request.maxTriangles.value_or(defaultMaxTriangles(settings.method));
    settings.morphing = request.morphing;
    if (request.viewMarginDeg) settings.viewMarginDeg = request.viewMarginDeg;
    settings.maxAdaptTimeUs = request.adaptTimeUs.value_or(settings.maxAdaptTimeUs);
    settings.adaptClock = request.adaptClock;
    settings.patchExponent = request.patchExponent.value_or(0);
    return terrain.setSettings(settings);
}

/// Whether two networks have roads of the same names and lengths.
bool areAlike(const osgRoads::core::RoadNetwork& a, const osgRoads::core::RoadNetwork& b)
{
    return std::equal(a.roads.begin(), a.roads.end(), b.roads.begin(), b.roads.end(),
                      [](const auto& one, const auto& other)
                      { return one.id == other.id && one.length == other.length; });
}

/// The roads of a scenario where the scene shows them: those of a georeferenced world lie in its frame, not
/// in that of their file. Those of the scene's own file are not read again.
foundation::Result<std::shared_ptr<const simulation::RoadScene>>
roadsFor(const simulation::Scenario& scenario, const std::filesystem::path& folder,
         const SceneTerrain& terrain)
{
    const bool areInScene = terrain.roads && terrain.origin();
    std::error_code failed;
    if (areInScene &&
        std::filesystem::equivalent(simulation::roadsFile(scenario, folder), terrain.roadsFile, failed))
        return roadSceneOf(terrain);
    auto roads = simulation::openRoads(scenario, folder);
    if (!roads || !*roads || !areInScene) return roads;
    return areAlike((*roads)->network(), terrain.roads->network()) ? roadSceneOf(terrain) : roads;
}

/// Adds what breaks the standard in the file of the roads that a play uses, where nothing has said it yet.
void addMistakes(const simulation::RoadScene* roads, std::vector<std::string>& notes)
{
    if (!roads) return;
    for (const foundation::Error& mistake : roads->mistakes())
        if (std::none_of(notes.begin(), notes.end(),
                         [&](const std::string& note)
                         { return note.find(mistake.what) != std::string::npos; }))
            notes.push_back(mistake.message());
}

/// Gives a field a share of its triangles.
void setBudget(osgPMObjects::ProgressiveField& field, osgPMObjects::core::SceneBudgetSettings budget,
               double share)
{
    if (budget.budget != std::numeric_limits<std::uint64_t>::max())
        budget.budget = static_cast<std::uint64_t>(share * static_cast<double>(budget.budget));
    (void)field.setBudget(budget); // valid, as the whole one is
}

/// Lets terrain and roads err by so many pixels from the next picture on.
void setTolerance(SceneTerrain& terrain, double tolerancePx)
{
    if (terrain.terrain)
    {
        osgTerrainROAM::RoamDrawableSettings settings = terrain.terrain->settings();
        settings.errorTolerancePx = tolerancePx;
        (void)terrain.terrain->setSettings(settings); // a number of pixels above 0
    }
    if (terrain.roads) setRoadTolerance(*terrain.node, tolerancePx);
}

/// Draws by these rules from the next picture on. Terrain and roads keep their tolerance.
void setQuality(PlayScene& play, const QualityRules& rules)
{
    play.scene->setQuality(rules);
    if (play.cover) play.cover->setReaches(rules.coverReaches);
    if (play.skyShade) play.skyShade->setShown(rules.hasSkyShade);
    for (const StandingPart& part : play.terrain.standing)
        if (part.field) setBudget(*part.field, part.fullBudget, rules.budgetShare);
    if (play.scenery) setBudget(*play.scenery->node.field, play.scenery->fullBudget, rules.budgetShare);
}

} // namespace

void drawWith(PlayScene& play, ChannelRig& rig, Quality quality, double tolerancePx, int drawnSide)
{
    QualityRules rules = rulesOf(quality);
    rules.pixelsPerRay *= drawnSide;
    setQuality(play, rules);
    rig.setDrawnSide(drawnSide * rules.drawnSide);
    setTolerance(play.terrain, drawnSide * tolerancePx); // counts pixels that are drawn
}

double nearPlaneM(const simulation::ScenarioObject& ownship, EyePoint eye)
{
    return ownship.isAirborne() || eye == EyePoint::above ? 5.0 : 1.0;
}

void addWeather(simulation::Scenario& scenario, const PlayRequest& request)
{
    if (request.weather || request.ground)
        scenario.storyboard.init.globals.push_back(simulation::EnvironmentAction{
            {}, simulation::Environment{{}, "weather", {}, request.weather, {}, {}, request.ground}});
}

simulation::SeatSettings seatSettingsOf(const PlayRequest& request)
{
    const SeatRequest& seat = *request.seat;
    return {seat.entity, seat.isTakenAtStart,        seat.vehicle,
            seat.inputs, !seat.recordInputs.empty(), request.seed};
}

std::shared_ptr<simulation::PersonSeat> seatOf(const simulation::PlayerOptions& options)
{
    return options.seats.empty()
               ? nullptr
               : std::dynamic_pointer_cast<simulation::PersonSeat>(options.seats.begin()->second);
}

namespace
{

/// Lets somebody sit where the request says.
foundation::Outcome addSeat(simulation::PlayerOptions& options, const simulation::Scenario& scenario,
                            const SceneTerrain& terrain, const PlayRequest& request)
{
    if (!request.seat) return foundation::success();
    const auto entity = simulation::seatIn(scenario, request.seat->entity);
    if (!entity) return entity.error();
    auto seat = simulation::PersonSeat::create(seatSettingsOf(request), scenario.entities[*entity],
                                               {groundForWheels(terrain), options.origin, terrain.obstacles});
    if (!seat) return seat.error();
    options.seats[request.seat->entity] = std::move(*seat);
    return foundation::success();
}

} // namespace

foundation::Result<simulation::PlayerOptions> playerOptionsOf(const simulation::Scenario& scenario,
                                                              const SceneTerrain& terrain,
                                                              const PlayRequest& request,
                                                              const simulation::FixedClock& clock)
{
    simulation::PlayerOptions stage;
    stage.origin = terrain.origin();
    stage.ground = terrain.ground();
    stage.air = terrain.air;
    stage.clock = clock;
    stage.seed = request.seed;
    stage.motionSource = std::make_shared<simulation::ScenarioMotions>(simulation::ScenarioMotions::World{
        groundForWheels(terrain), stage.origin, request.scenario.parent_path(), request.seed});
    if (!request.scenario.empty()) stage.scenarioName = request.scenario.string();
    const bool isOnRoads = !stage.origin && !scenario.roadNetwork.logicFile.empty(); // they are the scene
    if (isOnRoads || scenario.needsRoads())
    {
        // One that is not there is told by the player, with the place that needs it.
        auto roads = roadsFor(scenario, request.scenario.parent_path(), terrain);
        if (!roads) return roads.error();
        if (*roads && !stage.origin) stage.projection = simulation::projectionOf(**roads);
        stage.roads = std::move(*roads);
    }
    if (request.trafficRoads) stage.roads = request.trafficRoads;
    stage.motions = request.motions;
    stage.roadsUnder = request.roadsUnder;
    if (const auto seated = addSeat(stage, scenario, terrain, request); !seated) return seated.error();
    return stage;
}

foundation::Result<PlayScene> PlayScene::create(simulation::Scenario scenario, SceneTerrain terrain,
                                                const PlayRequest& request,
                                                const simulation::FixedClock& clock)
{
    if (scenario.entities.empty())
        return foundation::Error{request.scenario.string(), "no ScenarioObject in Entities",
                                 "add the one whose eye shall look"};
    const auto watch = request.terrain.opening->watched("makes the scene");
    const auto watched = watchedEntity(scenario, request.frames.eyeEntity);
    if (!watched) return watched.error();
    if (terrain.terrain)
        if (const auto set = configure(*terrain.terrain, request.terrain); !set) return set.error();
    addWeather(scenario, request);
    PlayScene play;
    play.terrain = std::move(terrain);
    play.watched = *watched;
    const auto stage = playerOptionsOf(scenario, play.terrain, request, clock);
    if (!stage) return stage.error();
    auto player = simulation::ScenarioPlayer::create(std::move(scenario), *stage);
    if (!player) return player.error();
    play.player = std::move(*player);
    addMistakes(stage->roads.get(), play.terrain.notes);
    play.seat = seatOf(*stage);
    if (!request.scenario.empty() && request.frames.eye != EyePoint::free)
        if (const auto placed =
                checkPlaceOnGround(*play.player, play.watched, play.terrain, request.scenario.string());
            !placed)
            return placed.error();
    request.terrain.opening->end("scenario");
    simulation::PlayerOptions ahead = *stage;
    ahead.seats.clear(); // where the scenario goes by itself
    auto scenery = makeScenery(request.scenery, request.frames.durationS(), play.player->scenario(), ahead,
                               play.terrain);
    if (!scenery) return scenery.error();
    play.scenery = *std::move(scenery);
    request.terrain.opening->end("scenery");
    auto scene = ScenarioScene::create(play.player->scenario(), play.terrain, request.scenario.parent_path());
    if (!scene) return scene.error();
    play.scene = std::make_unique<ScenarioScene>(std::move(*scene));
    play.scene->bearLamps(play.watched);
    play.scene->setShadows(request.frames.hasShadows);
    play.scene->setLightSteps(request.frames.lightSteps);
    if (request.clouds) play.scene->setClouds(*request.clouds);
    request.terrain.opening->end("entities");
    if (play.scenery) play.scene->sunlit().addChild(play.scenery->node.root);
    play.cover = makeCover(play.terrain);
    if (play.cover) play.scene->sunlit().addChild(play.cover->node());
    play.skyShade = makeSkyShade(play.terrain, play.scenery ? &play.scenery->occluders : nullptr);
    if (play.skyShade) play.scene->sunlit().addChild(play.skyShade->node());
    request.terrain.opening->end("cover");
    return play;
}

std::vector<std::string> PlayScene::notes() const
{
    std::vector<std::string> notes = terrain.notes;
    const std::vector<std::string> ofEntities = scene->notes();
    notes.insert(notes.end(), ofEntities.begin(), ofEntities.end());
    if (scenery) notes.insert(notes.end(), scenery->notes.begin(), scenery->notes.end());
    return notes;
}

} // namespace trainer
