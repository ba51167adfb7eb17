// SPDX-License-Identifier: Apache-2.0
#include "terraintool/TourViews.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "ground/TileGround.h"
#include "sim/player/ScenarioPlayer.h"

namespace terraintool
{

namespace
{

constexpr int kWidthPx = 960, kHeightPx = 540, kFramesPerSecond = 24;
constexpr double kFovYDeg = 40.0, kNearM = 1.0, kFarM = 300000.0;

viewlod::ViewState viewOf(const trainer::EntityState& state)
{
    const glm::dmat3 body = state.bodyToLocal(); // forward, left, up
    const glm::dmat4 view = glm::lookAt(state.position, state.position + body[0], body[2]);
    const double aspect = static_cast<double>(kWidthPx) / kHeightPx;
    return viewlod::ViewState::fromMatrices(
        view, glm::perspective(glm::radians(kFovYDeg), aspect, kNearM, kFarM), kWidthPx, kHeightPx);
}

} // namespace

viewlod::Result<std::vector<viewlod::ViewState>> tourViews(const osgTerrainROAM::core::PlacedTile& tile,
                                                           int frames)
{
    const trainer::TourOptions options;
    auto tour = trainer::layTour(ground::tourTerrainOf(tile, ""), options);
    if (!tour) return tour.error();
    const trainer::FixedClock clock = trainer::FixedClock::forFrameRate(kFramesPerSecond);
    auto player = trainer::ScenarioPlayer::create(
        std::move(tour->scenario), {ground::originOf(tile), ground::groundOf(tile), clock, "tour"});
    if (!player) return player.error();
    const double stepsPerView = options.durationS * static_cast<double>(clock.stepsPerSecond()) / frames;
    std::vector<viewlod::ViewState> views;
    for (int frame = 0; frame < frames; ++frame)
    {
        const auto due = static_cast<std::int64_t>(frame * stepsPerView);
        while ((*player)->clock().step() < due && !(*player)->isFinished())
            (*player)->step();
        views.push_back(viewOf((*player)->entities().front()));
    }
    return views;
}

} // namespace terraintool
