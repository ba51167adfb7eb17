// SPDX-License-Identifier: Apache-2.0
#include "terraintool/FlightViews.h"

#include <cmath>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/ground/TileGround.h"
#include "simulation/player/ScenarioPlayer.h"

namespace terraintool
{

namespace
{

constexpr int kWidthPx = 960, kHeightPx = 540, kFramesPerSecond = 24;
constexpr double kFovYDeg = 40.0, kNearM = 1.0, kFarM = 300000.0;
constexpr double kDriverEyeM = 1.5;

using Player = std::unique_ptr<simulation::ScenarioPlayer>;

foundation::Result<Player> playerOver(const osgTerrainROAM::core::PlacedTile& tile,
                                      simulation::Scenario scenario, const std::string& name)
{
    simulation::PlayerOptions options;
    options.origin = ground::originOf(tile);
    options.ground = ground::groundOf(tile);
    options.clock = simulation::FixedClock::forFrameRate(kFramesPerSecond);
    options.scenarioName = name;
    return simulation::ScenarioPlayer::create(std::move(scenario), std::move(options));
}

/// Returns the current view of the first entity.
viewlod::ViewState viewOf(const simulation::ScenarioPlayer& player)
{
    const simulation::EntityState& state = player.entities().front();
    const glm::dmat3 body = state.bodyToLocal(); // forward, left, up
    const bool isAirborne = player.scenario().entities.front().isAirborne();
    const glm::dvec3 eye = state.position + body[2] * (isAirborne ? 0.0 : kDriverEyeM);
    const glm::dmat4 view = glm::lookAt(eye, eye + body[0], body[2]);
    const double aspect = static_cast<double>(kWidthPx) / kHeightPx;
    return viewlod::ViewState::fromMatrices(
        view, glm::perspective(glm::radians(kFovYDeg), aspect, kNearM, kFarM), kWidthPx, kHeightPx);
}

/// Returns one view after each `stepsPerView` steps, the first at the start.
std::vector<viewlod::ViewState> viewsOf(simulation::ScenarioPlayer& player, double stepsPerView, int frames)
{
    std::vector<viewlod::ViewState> views;
    while (static_cast<int>(views.size()) < frames)
    {
        const auto due = static_cast<std::int64_t>(static_cast<double>(views.size()) * stepsPerView);
        while (player.clock().step() < due && !player.isFinished())
            player.step();
        if (player.clock().step() < due) break;
        views.push_back(viewOf(player));
    }
    return views;
}

} // namespace

foundation::Result<std::vector<viewlod::ViewState>> tourViews(const osgTerrainROAM::core::PlacedTile& tile,
                                                              int frames)
{
    const simulation::TourOptions options;
    auto tour = simulation::layTour(ground::tourTerrainOf(tile, ""), options);
    if (!tour) return tour.error();
    const auto player = playerOver(tile, std::move(tour->scenario), "tour");
    if (!player) return player.error();
    const auto stepsPerSecond = static_cast<double>((*player)->clock().stepsPerSecond());
    return viewsOf(**player, options.durationS * stepsPerSecond / frames, frames);
}

foundation::Result<std::vector<viewlod::ViewState>>
scenarioViews(simulation::Scenario scenario, const std::string& name,
              const osgTerrainROAM::core::PlacedTile& tile, int frames)
{
    if (scenario.entities.empty())
        return foundation::Error{name, "no ScenarioObject in Entities", "add the one whose eye shall look"};
    const auto player = playerOver(tile, std::move(scenario), name);
    if (!player) return player.error();
    const auto stepsPerSecond = static_cast<double>((*player)->clock().stepsPerSecond());
    return viewsOf(**player, stepsPerSecond / kFramesPerSecond, frames);
}

} // namespace terraintool
