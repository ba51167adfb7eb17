// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "request/PlayRequest.h"
#include "scene/ScenarioScene.h"
#include "scene/SceneCover.h"
#include "scene/SceneScenery.h"
#include "simulation/control/scenario/PersonSeat.h"
#include "simulation/player/ScenarioPlayer.h"
#include "view/Channel.h"

namespace trainer
{

class ChannelRig;

/// A scenario over its terrain, ready to be stepped and drawn, offscreen or in a window.
struct PlayScene
{
    SceneTerrain terrain;
    std::unique_ptr<simulation::ScenarioPlayer> player;
    std::shared_ptr<simulation::PersonSeat> seat; ///< in the player; null: nobody may sit anywhere
    std::unique_ptr<ScenarioScene> scene;
    std::optional<SceneScenery> scenery;
    std::unique_ptr<scenery::GroundCoverNode> cover; ///< null: none
    std::unique_ptr<scenery::SkyShadeNode> skyShade; ///< null: none
    std::size_t watched = 0;                         ///< the entity that the eye is in or looks at

    /// `terrain`: from openScene(). Errors: a scenario without entities or with other faults, an entity to
    /// watch that there is not or that begins off the ground (checkPlaceOnGround()), terrain settings, models
    /// and scenery that cannot be used.
    static foundation::Result<PlayScene> create(simulation::Scenario scenario, SceneTerrain terrain,
                                                const PlayRequest& request,
                                                const simulation::FixedClock& clock);

    /// Brings what stands around the eye only. Frame: world.
    void follow(const glm::dvec3& eye) const
    {
        scene->follow(eye);
        if (cover) cover->follow(eye);
        if (skyShade) skyShade->follow(eye);
    }

    /// Returns one line for each difference from what was asked for.
    std::vector<std::string> notes() const;

    /// Says which eye it is seen from.
    void setEye(EyePoint eye) { scene->ride(movesWithOwnship(eye) ? std::optional(watched) : std::nullopt); }

    const simulation::ScenarioObject& ownship() const { return player->scenario().entities[watched]; }
};

/// Steps a second where somebody may sit in an entity: the same at every rate of pictures, so that inputs
/// repeat.
inline constexpr int kSeatStepsPerSecond = 120;

/// Draws with a quality from the next picture on, and lets terrain and roads err by so many pixels of it.
/// `drawnSide`: so many pixels are drawn along each side of one (osgOffscreen::FrameBuffer::drawnSide()).
void drawWith(PlayScene& play, ChannelRig& rig, Quality quality, double tolerancePx, int drawnSide);

/// Lets the weather of a request hold in a scenario from the begin on, after the scenario's own.
void addWeather(simulation::Scenario& scenario, const PlayRequest& request);

/// How somebody sits in a scenario. Needs a request with a seat that names its entity.
simulation::SeatSettings seatSettingsOf(const PlayRequest& request);

/// The seat among the options of a player; null: none.
std::shared_ptr<simulation::PersonSeat> seatOf(const simulation::PlayerOptions& options);

/// How a scenario is played over a terrain. Errors: a road network that cannot be read; a seat that cannot be
/// made.
foundation::Result<simulation::PlayerOptions> playerOptionsOf(const simulation::Scenario& scenario,
                                                              const SceneTerrain& terrain,
                                                              const PlayRequest& request,
                                                              const simulation::FixedClock& clock);

/// Returns the near plane of a view that sets none, as far away as possible, because the depth resolution at
/// a distance is proportional to it. A driver sees the ground from 4 m on, a pilot or an eye above a car from
/// much farther.
double nearPlaneM(const simulation::ScenarioObject& ownship, EyePoint eye);

/// The same for somebody who sits inside and sees the ground near the own wheels. Units: metres.
inline constexpr double kNearFromInsideM = 1.0;

} // namespace trainer
