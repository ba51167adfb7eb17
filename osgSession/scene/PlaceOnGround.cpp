// SPDX-License-Identifier: Apache-2.0
#include "PlaceOnGround.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include <osgRoads/core/query/BoxTree.h>

#include "SceneTerrain.h"
#include "osgSession/src/core/ScenarioPlace.h"

namespace trainer
{

namespace
{

/// An aircraft that begins so far off the ground sees it, and may fly there.
constexpr double kSightM = 20e3;
/// Deeper than this no eye looks out of the ground; a wheel's contact in a coarse raster errs by less.
constexpr double kBuriedM = 10.0;

/// Returns the box of the data in the plan. Frame: the scene's. Units: metres.
osgRoads::core::PlanBox extentOf(const SceneTerrain& scene)
{
    const auto& tile = scene.terrain->tile()->tile;
    const int lastColumn = tile.grid().dataColumns() - 1, lastRow = tile.grid().dataRows() - 1;
    osgRoads::core::PlanBox extent;
    const auto include = [&](int column, int row)
    { extent.include(glm::dvec2(tile.position(column, row)) + scene.cornerM); };
    for (int row = 0; row <= lastRow; ++row)
        for (const int column : {0, lastColumn})
            include(column, row);
    for (int column = 0; column <= lastColumn; ++column)
        for (const int row : {0, lastRow})
            include(column, row);
    return extent;
}

/// Absent: the scenario counts in metres of the scene.
std::optional<simulation::LocalFrame> frameOf(const simulation::Scenario& scenario, const SceneTerrain& scene)
{
    const auto origin = scene.origin();
    if (!origin || !placeOnEarth(scenario)) return std::nullopt;
    return simulation::LocalFrame(*origin);
}

std::string placeText(const std::optional<simulation::LocalFrame>& frame, const glm::dvec3& place)
{
    char text[96];
    if (frame)
    {
        const simulation::Geodetic there = frame->geodeticFromLocal(place);
        std::snprintf(text, sizeof text, "latitude %.4f, longitude %.4f", there.latitudeDeg,
                      there.longitudeDeg);
    }
    else
        std::snprintf(text, sizeof text, "x %.0f m, y %.0f m", place.x, place.y);
    return text;
}

std::string lengthText(double metres)
{
    const bool isFar = metres >= 10e3;
    char text[32];
    std::snprintf(text, sizeof text, isFar ? "%.0f km" : "%.0f m", isFar ? 1e-3 * metres : metres);
    return text;
}

} // namespace

foundation::Outcome checkPlaceOnGround(const simulation::ScenarioPlayer& player, std::size_t entity,
                                       const SceneTerrain& terrain, const std::string& scenario)
{
    const simulation::EntityState& state = player.entities()[entity];
    const simulation::GroundProvider ground = terrain.ground();
    if (!ground || !state.isPresent) return foundation::success();
    const bool isAirborne = player.scenario().entities[entity].isAirborne();
    const auto frame = frameOf(player.scenario(), terrain);
    const glm::dvec3& place = state.position;
    const std::string begins = state.name + " begins at " + placeText(frame, place) + ", ";
    const osgRoads::core::PlanBox extent = extentOf(terrain);
    const double distanceM = std::sqrt(extent.squareTo(place));
    const auto surface = ground(place.x, place.y, place.z);
    if (isAirborne ? distanceM > kSightM : !surface)
        return foundation::Error{
            scenario,
            begins + (distanceM > 0.0 ? lengthText(distanceM) + " from" : "in a gap of") +
                " the ground, which reaches from " + placeText(frame, {extent.least, 0.0}) + " to " +
                placeText(frame, {extent.most, 0.0}),
            "give --terrain FILE of that place, or a scenario of this one"};
    if (surface && surface->heightM - place.z > kBuriedM)
        return foundation::Error{scenario,
                                 begins + lengthText(surface->heightM - place.z) + " below the ground",
                                 "give --terrain FILE of that place, or another height"};
    return foundation::success();
}

} // namespace trainer
