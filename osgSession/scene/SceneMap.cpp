// SPDX-License-Identifier: Apache-2.0
#include "SceneMap.h"

#include <algorithm>
#include <string>

#include "MapObjects.h"
#include "ReadShapes.h"
#include "scenery/buildings/BuildingObstacles.h"
#include "scenery/buildings/Outline.h"
#include "scenery/buildings/StandBuildings.h"
#include "scenery/lights/RunwayLights.h"
#include "scenery/models/Catalogue.h"
#include "scenery/nodes/BuildingsNode.h"
#include "scenery/nodes/SceneryNode.h"
#include "scenery/placement/PlacedObstacles.h"
#include "scenery/roads/NearestStreet.h"

namespace trainer
{

namespace
{

constexpr double kTreesGoneM = 1600.0, kTreesFadeM = 1300.0, kHousesGoneM = 8000.0;
static_assert(kTreesFadeM >= 1000.0); // an eye over a wood sees trees for a kilometre
constexpr std::uint64_t kBudgetTriangles = 400000;

/// Vehicles by the continuous rule T with geomorph: level by level as far as the vertex.
void drawContinuously(scenery::SceneryField& field, scenery::models::Kind kind)
{
    // Aircraft are seen from farther away, as far as their size says.
    const bool isAircraft = kind > scenery::models::Kind::bus;
    const double farther = isAircraft ? scenery::models::factsOf(kind).mostRadiusM / 3.0 : 1.0;
    field.selection.settings.method = osgPMObjects::core::SelectionMethod::continuous;
    field.selection.settings.continuousBand = 1.1;
    field.selection.settings.alpha = osgPMObjects::core::AlphaRange{1500.0 * farther, 2000.0 * farther};
    field.switching.method = osgPMObjects::core::SwitchMethod::geomorph;
}

/// Houses by ranges that overlap.
void drawByRanges(scenery::SceneryField& field)
{
    field.selection.settings.method = osgPMObjects::core::SelectionMethod::overlappingRanges;
    field.selection.boundariesM = {120.0, 300.0, 700.0, 1600.0};
    field.selection.facesPercent = {100.0, 60.0, 30.0, 14.0, 6.0};
    field.selection.settings.alpha = osgPMObjects::core::AlphaRange{0.9 * kHousesGoneM, kHousesGoneM};
    field.switching.method = osgPMObjects::core::SwitchMethod::blend;
}

/// The settings by which a kind is drawn: trees share a budget.
scenery::SceneryField fieldOf(const scenery::SceneryObject& object, std::size_t number)
{
    scenery::SceneryField field;
    field.name = std::to_string(number);
    field.objects = {object};
    if (*object.kind >= scenery::models::Kind::saloon)
        drawContinuously(field, *object.kind);
    else if (*object.kind >= scenery::models::Kind::familyHouse)
        drawByRanges(field);
    else
    {
        field.selection.settings.method = osgPMObjects::core::SelectionMethod::budget;
        field.selection.settings.leastFaces = 24;
        field.selection.settings.alpha = osgPMObjects::core::AlphaRange{kTreesFadeM, kTreesGoneM};
    }
    return field;
}

/// The points of maps as placed models.
class Objects
{
public:
    Objects() { _description.budget.budget = kBudgetTriangles; }

    void add(const MapObjects& made)
    {
        std::vector<std::uint32_t> numbers;
        for (const MapModel& model : made.models)
            numbers.push_back(numberOf({static_cast<scenery::models::Kind>(model.kind), model.seed, {}}));
        _placed.placements.reserve(_placed.placements.size() + made.objects.size());
        for (const MapObject& object : made.objects)
        {
            const std::uint32_t number = numbers[object.model];
            _placed.placements.push_back(
                {object.position, scenery::uprightAxes(object.headingRad), object.scale, number, number});
        }
        unused += made.unused;
    }

    /// Once.
    foundation::Outcome addTo(MapScenery& map, const std::string& place, bool wantsObstacles)
    {
        const auto shapes = scenery::makeSceneryShapes(scenery::objectsOf(_description));
        if (!shapes) return shapes.error();
        if (wantsObstacles) scenery::addObstacles(_description, _placed, shapes->measures, map.obstacles);
        scenery::SkyOccluders occluders = scenery::occludersOf(_description, _placed, shapes->measures);
        const auto node =
            scenery::makeSceneryNode(_description, std::move(_placed.placements), *shapes, place);
        if (!node) return node.error();
        map.standing.push_back(
            {"trees and vehicles", node->root, node->field, node->field->budget(), std::move(occluders)});
        return foundation::success();
    }

    bool isEmpty() const { return _placed.placements.empty(); }
    std::uint64_t unused = 0;

private:
    std::uint32_t numberOf(const scenery::SceneryObject& object)
    {
        const auto same = [&](const scenery::SceneryField& field) { return field.objects.front() == object; };
        const auto found = std::find_if(_description.fields.begin(), _description.fields.end(), same);
        const auto number = static_cast<std::size_t>(found - _description.fields.begin());
        if (found == _description.fields.end()) _description.fields.push_back(fieldOf(object, number));
        return static_cast<std::uint32_t>(number);
    }

    scenery::SceneryDescription _description; ///< a field for each model
    scenery::PlacedScenery _placed;
};

foundation::Error nothingIn(const std::filesystem::path& source, const char* remedy)
{
    return {source.string(), "has nothing that can stand here", remedy};
}

scenery::SkyOccluders wallsOf(const std::vector<scenery::StandingBuilding>& buildings)
{
    scenery::SkyOccluders occluders;
    for (const scenery::StandingBuilding& standing : buildings)
        for (std::size_t r = 0; r < standing.building.rings.size(); ++r)
        {
            const auto& ring = standing.building.rings[r];
            for (std::size_t i = 0; i < ring.size(); ++i)
                occluders.walls.push_back(
                    {ring[i], ring[(i + 1) % ring.size()],
                     standing.floorM + standing.building.eavesM - standing.groundAt(r, i, 0.5)});
        }
    return occluders;
}

/// Notes where people are, and what a building has on its top: a control tower the beacon of its airfield,
/// whatever is high a lamp for those who fly.
void noteLights(const scenery::StandingBuilding& standing, MapScenery& map)
{
    constexpr double kHighM = 45.0;
    const scenery::Building& building = standing.building;
    const glm::dvec2 middle = scenery::rectangleAround(building.rings.front()).middle;
    if (building.openings == scenery::Openings::house && building.rooms != scenery::RoomUse::unused)
        map.houses.push_back(middle);
    const double aboveM = building.eavesM + building.roofM + 1.0;
    const glm::dvec3 top(middle, standing.floorM + aboveM);
    const bool isTower = building.openings == scenery::Openings::control;
    if (isTower)
        for (const scenery::LightPoint& light : scenery::beaconLights(top))
            map.lights.push_back(light);
    if (isTower || aboveM > kHighM) map.lights.push_back(scenery::obstacleLight(top));
}

foundation::Outcome addBuildings(const std::filesystem::path& source,
                                 const osgTerrainROAM::core::RoamTile& tile,
                                 const foundation::HeightInPlan& ground, const scenery::NearestStreet& street,
                                 MapScenery& map, bool wantsObstacles)
{
    const auto shapes = readShapes(source, tile);
    if (!shapes) return shapes.error();
    map.notes.insert(map.notes.end(), shapes->notes.begin(), shapes->notes.end());
    const scenery::StandingBuildings made = scenery::standBuildings(*shapes, ground, street);
    if (made.buildings.empty()) return nothingIn(source, "give footprints of buildings of this place");
    map.notes.push_back(source.string() + ": " + std::to_string(made.buildings.size()) + " buildings; " +
                        std::to_string(shapes->outside + made.beyondGround) + " beyond the ground, " +
                        std::to_string(shapes->lines + shapes->invalid + made.unusable) + " not usable");
    if (wantsObstacles)
    {
        scenery::addObstacles(made.buildings, map.obstacles);
        scenery::addRoofs(made.buildings, map.obstacles);
    }
    for (const scenery::StandingBuilding& standing : made.buildings)
        noteLights(standing, map);
    map.standing.push_back({"buildings",
                            scenery::makeBuildingsNode(made.buildings, &map.panes),
                            nullptr,
                            {},
                            wallsOf(made.buildings)});
    return foundation::success();
}

} // namespace

foundation::Result<MapScenery> makeMapScenery(const osgTerrainROAM::core::RoamFile& description,
                                              const osgTerrainROAM::core::RoamTile& tile,
                                              const foundation::HeightInPlan& ground,
                                              const osgRoads::core::PlacedNetwork* roads, bool wantsObstacles)
{
    MapScenery map;
    const scenery::NearestStreet street = roads ? scenery::nearestStreet(*roads) : scenery::NearestStreet();
    for (const std::filesystem::path& source : description.buildings)
        if (const auto added = addBuildings(source, tile, ground, street, map, wantsObstacles); !added)
            return added.error();
    Objects objects;
    for (const std::filesystem::path& source : description.objects)
    {
        const auto made = readMapObjects(source, tile, ground);
        if (!made) return made.error();
        map.notes.insert(map.notes.end(), made->notes.begin(), made->notes.end());
        objects.add(*made);
        if (objects.isEmpty()) return nothingIn(source, "give points with a kind of the generated models");
    }
    if (objects.unused > 0)
        map.notes.push_back("objects: " + std::to_string(objects.unused) +
                            " of no known kind, or beyond the ground");
    if (!objects.isEmpty())
        if (const auto added = objects.addTo(map, "objects", wantsObstacles); !added) return added.error();
    return map;
}

} // namespace trainer
