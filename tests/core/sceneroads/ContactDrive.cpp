// SPDX-License-Identifier: Apache-2.0
#include "ContactDrive.h"

#include <algorithm>
#include <sstream>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/query/ChooseDrive.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "scenery/roads/CutRoads.h"
#include "scenery/roads/HeightOnRoads.h"
#include "scenery/roads/LanePath.h"
#include "scenery/roads/LayRoads.h"
#include "scenery/roads/RoadGround.h"
#include "scenery/roads/TunnelOpenings.h"
#include "simulation/tour/LayDrive.h"

namespace
{

using namespace osgTerrainROAM::core;

constexpr int kWidthPx = 960, kHeightPx = 540;
constexpr double kVergeM = 1.0; ///< how far beside the lanes something may stand
const glm::dvec3 kDriverEye(1.25, 0.36, 1.2);

viewlod::ViewState viewFrom(const glm::dvec3& eye, const glm::dvec3& at)
{
    return viewlod::ViewState::fromMatrices(
        glm::lookAt(eye, at, {0.0, 0.0, 1.0}),
        glm::perspective(glm::radians(40.0), double(kWidthPx) / kHeightPx, 1.0, 2e5), kWidthPx, kHeightPx);
}

void tell(std::ostream& out, const scenery::DrawnContact& worst)
{
    out << 1000.0 * worst.gapM << " mm, " << worst.gapPx << " px at " << worst.distanceM << " m, place "
        << worst.place.x << ' ' << worst.place.y << ' ' << worst.place.z;
}

/// Whether a place is on the face of a kerb: the surface beside it, 1 cm away, is another 2 cm or more higher
/// or lower.
bool isOnStep(const simulation::GroundProvider& ground, const glm::dvec3& place)
{
    constexpr double kAsideM = 0.01, kStepM = 0.02;
    for (const glm::dvec2& aside : {glm::dvec2(kAsideM, 0.0), glm::dvec2(-kAsideM, 0.0),
                                    glm::dvec2(0.0, kAsideM), glm::dvec2(0.0, -kAsideM)})
        if (const auto sample = ground(place.x + aside.x, place.y + aside.y, place.z + 0.5);
            sample && std::abs(sample->heightM - place.z) > kStepM)
            return true;
    return false;
}

/// Points ahead of the car: on its lane and on both verges, at the heights on which something stands there.
std::vector<glm::dvec3> pointsAhead(const RoadScene& scene, const simulation::GroundProvider& ground,
                                    const simulation::EntityState& car)
{
    std::vector<glm::dvec3> points;
    const auto on = scene.roads->locator().nearest(scene.roads->toInertial(car.position));
    if (!on) return points;
    const auto& road = scene.roads->road(on->position.road);
    const glm::dvec3 ahead = car.bodyToLocal()[0];
    const glm::dvec3 way = scene.roads->surfacePoint(on->position.road, on->position.s + 0.1, 0.0) -
                           scene.roads->surfacePoint(on->position.road, on->position.s, 0.0);
    const double sign = glm::dot(way, ahead) >= 0.0 ? 1.0 : -1.0;
    for (const double aheadM : {6.0, 10.0, 15.0, 25.0, 40.0, 70.0, 120.0, 200.0, 400.0, 800.0})
    {
        const double s = on->position.s + sign * aheadM;
        if (s <= 0.0 || s >= road.length) continue;
        const auto lanes = osgRoads::core::extentAt(road, s);
        const auto* structure = osgRoads::core::structureAt(road, s);
        const bool hasVerges =
            !structure ||
            structure->kind != osgRoads::core::StructureKind::tunnel; // it has walkways, which are models
        for (const double t : {on->position.t, lanes.rightT - kVergeM, lanes.leftT + kVergeM})
        {
            if (t != on->position.t && !hasVerges) continue;
            glm::dvec3 place = scene.roads->surfacePoint(on->position.road, s, t);
            if (const auto sample = ground(place.x, place.y, place.z)) place.z = sample->heightM;
            if (!isOnStep(ground, place)) points.push_back(place);
        }
    }
    return points;
}

std::vector<glm::dvec3> wheelsOf(const simulation::GroundContact& contact, const simulation::EntityState& car)
{
    std::vector<glm::dvec3> wheels;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const glm::dvec3 inBody(i < 2 ? contact.frontXM : contact.rearXM,
                                i % 2 == 0 ? contact.halfTrackM : -contact.halfTrackM, car.wheelTravelM[i]);
        wheels.push_back(car.position + car.bodyToLocal() * inBody);
    }
    return wheels;
}

/// Makes what is drawn of the roads, and where the ground is left out for them.
void draw(RoadScene& scene)
{
    scene.mesh = osgRoads::core::buildRoadMesh(*scene.roads);
    auto openings = OpeningCells::build(scenery::tunnelOpenings(*scene.roads));
    EXPECT_TRUE(openings) << (openings ? "" : openings.error().message());
    if (openings) scene.openings = std::move(*openings);
}

} // namespace

DrawnWatcher::DrawnWatcher(const RoadScene& scene, const ContactRequest& request)
    : _scene(scene), _request(request), _ground(SplitBounds(scene.tile))
{
}

void DrawnWatcher::look(const glm::dvec3& eye, const glm::dvec3& at)
{
    const viewlod::ViewState view = viewFrom(eye, at);
    _ground.refine(view, {.errorTolerancePx = 1.0, .maxTriangles = 500000});
    osgRoads::core::RoadViewSettings settings;
    auto choices = osgRoads::core::chooseLevels(_scene.mesh, view, settings);
    for (auto& choice : choices)
    {
        const auto levels = static_cast<std::uint32_t>(_scene.mesh.chunks[choice.chunk].levels.size());
        choice.level = std::min(choice.level + _request.coarser, levels - 1);
    }
    _drawn.emplace(scenery::DrawnScene{_ground.tree(), _scene.mesh, std::move(choices), settings, view,
                                       &_scene.openings});
}

void DrawnWatcher::check(const glm::dvec3& place, ContactReport& report) const
{
    const glm::dvec4 clip = _drawn->view.clipFromWorld * glm::dvec4(place, 1.0);
    if (std::max(std::abs(clip.x), std::abs(clip.y)) > clip.w) return; // not in the image
    const auto contact = scenery::contactAt(*_drawn, place + glm::dvec3(0.0, 0.0, _request.raisedM));
    ++report.points;
    report.undrawn += contact ? 0 : 1;
    if (!contact) return;
    report.broken += contact->isKept() ? 0 : 1;
    const bool isNear = contact->distanceM <= scenery::DrawnContact::kNearM;
    if (isNear && std::abs(contact->gapM) > std::abs(report.worstNear.gapM)) report.worstNear = *contact;
    if (!isNear && std::abs(contact->gapPx) > std::abs(report.worstFar.gapPx)) report.worstFar = *contact;
}

simulation::PlayerOptions RoadScene::stage() const
{
    simulation::PlayerOptions options;
    if (tile->tile.frame().placement() != Placement::planar)
    {
        const auto& origin = tile->tile.frame().origin();
        options.origin = {origin.latitudeDeg, origin.longitudeDeg, origin.heightM};
    }
    options.ground = [this](double east, double north, double from) -> std::optional<simulation::GroundSample>
    {
        const auto bare = groundAt(tile->tile, east, north);
        if (!bare) return std::nullopt;
        return simulation::GroundSample{scenery::heightOnRoads(*roads, bare->position, from)};
    };
    options.clock = simulation::FixedClock::forFrameRate(24);
    return options;
}

RoadScene sceneOf(std::shared_ptr<RoamTile> tile, std::shared_ptr<const osgRoads::core::PlacedNetwork> roads)
{
    RoadScene scene{std::move(tile), std::move(roads), {}, {}};
    TileEditor editor(scene.tile);
    EXPECT_TRUE(scenery::cutRoads(editor, *scene.roads));
    draw(scene);
    return scene;
}

RoadScene sceneOf(const std::filesystem::path& file)
{
    if (file.extension() == ".xodr")
    {
        auto ground = scenery::makeRoadGround(file);
        EXPECT_TRUE(ground) << (ground ? "" : ground.error().message());
        if (!ground) return {};
        PlacedTileOptions options{.placement = Placement::planar};
        options.gridExponent = gridExponentFor(ground->field, 2.0);
        return sceneOf(std::make_shared<RoamTile>(PlacedTile(std::move(ground->field), options)),
                       ground->roads.placed);
    }
    const auto description = describeTerrain(file, {});
    auto placed = loadTile(*description);
    EXPECT_TRUE(placed) << (placed ? "" : placed.error().message());
    RoadScene scene{std::make_shared<RoamTile>(std::move(*placed)), nullptr, {}, {}};
    const auto roads = scenery::layRoads(*description, scene.tile);
    EXPECT_TRUE(roads) << (roads ? "" : roads.error().message());
    scene.roads = roads->placed;
    draw(scene);
    return scene;
}

simulation::Scenario driveOver(const RoadScene& scene, double durationS)
{
    const auto& network = scene.roads->network();
    const auto route = osgRoads::core::chooseDrive(network, osgRoads::core::LaneGraph(network),
                                                   durationS * scenery::defaultSpeedMps(network));
    std::vector<simulation::WayPoint> way;
    for (const scenery::LanePathPoint& point : scenery::lanePath(*scene.roads, route))
        way.push_back({point.place, point.limitMps});
    simulation::TourTerrain terrain{-1e5, -1e5, 1e5,    1e5, [](double, double) { return 0.0; },
                                    1.0,  {},   "scene"};
    terrain.origin = scene.stage().origin;
    const auto drive = simulation::layDriveAlong(terrain, std::move(way), durationS);
    EXPECT_TRUE(drive) << (drive ? "" : drive.error().message());
    return drive ? drive->scenario : simulation::Scenario();
}

std::string ContactReport::text() const
{
    std::ostringstream out;
    out << frames << " frames, " << points << " points, " << broken << " broken, " << undrawn
        << " undrawn; near: ";
    tell(out, worstNear);
    out << "; far: ";
    tell(out, worstFar);
    return out.str();
}

ContactReport contactsOf(const RoadScene& scene, simulation::Scenario scenario, const ContactRequest& request)
{
    ContactReport report;
    const simulation::PlayerOptions stage = scene.stage();
    auto player = simulation::ScenarioPlayer::create(std::move(scenario), stage);
    EXPECT_TRUE(player) << (player ? "" : player.error().message());
    if (!player) return report;
    const auto contact = simulation::GroundContact::of((*player)->scenario().entities.front());
    DrawnWatcher driver(scene, request), behind(scene, request);
    const auto stepsPerFrame = stage.clock.stepsPerSecond() / 24 * request.everyFrames;
    for (; !(*player)->isFinished(); ++report.frames)
    {
        const simulation::EntityState& car = (*player)->entities().front();
        const glm::dmat3 body = car.bodyToLocal();
        const glm::dvec3 eye = car.position + body * kDriverEye;
        driver.look(eye, eye + body[0]);
        behind.look(car.position - 9.0 * body[0] + glm::dvec3(0.0, 0.0, 2.8), car.position);
        for (const glm::dvec3& wheel : wheelsOf(contact, car))
            behind.check(wheel, report);
        for (const glm::dvec3& place : pointsAhead(scene, stage.ground, car))
            driver.check(place, report);
        for (auto i = stepsPerFrame; i > 0; --i)
            (*player)->step();
    }
    return report;
}
