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
    return viewlod::ViewState::fromMatrices(view, glm::perspective(glm::radians(kFovYDeg), aspect, kNearM, kFarM), kWidthPx,
                                            kHeightPx);
}

} // namespace

viewlod::Result<std::vector<viewlod::ViewState>> tourViews(const osgTerrainROAM::core::PlacedTile& tile, int frames)
{
    trainer::TourOptions options;
    options.durationS = static_cast<double>(frames) / kFramesPerSecond;
    auto tour = trainer::layTour(ground::tourTerrainOf(tile, ""), options);
    if (!tour) return tour.error();
    trainer::PlayerOptions stage{ground::originOf(tile), ground::groundOf(tile), trainer::FixedClock::forFrameRate(kFramesPerSecond)};
    auto player = trainer::ScenarioPlayer::create(std::move(tour->scenario), std::move(stage));
    if (!player) return player.error();
    std::vector<viewlod::ViewState> views;
    for (int frame = 0; frame < frames; ++frame)
    {
        views.push_back(viewOf((*player)->entities().front()));
        for (auto i = (*player)->clock().stepsPerSecond() / kFramesPerSecond; i > 0; --i) (*player)->step();
    }
    return views;
}

} // namespace terraintool
