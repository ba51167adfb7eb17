// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "PlayScene.h"
#include "view/ChannelRig.h"
#include "view/InteriorView.h"

namespace trainer
{

/// The inside of the watched entity in a play: its instruments follow whatever moves it. Threads: the update
/// phase.
class SceneInterior
{
public:
    /// A picture of the inside: from where, through which screen, and which mirrors are drawn for it.
    struct Picture
    {
        const scenery::Pose& eye;
        const ChannelRig& rig;
        MirrorPace pace;
    };

    /// The height of a picture from inside. Units: degrees. Wider than from outside, to have windows and
    /// instruments in sight.
    static constexpr double kPictureDeg = 55.0;

    /// Begins to draw the inside of `play`'s watched entity over the first channel of `rig`. Null: one does
    /// not sit inside of it.
    static std::unique_ptr<SceneInterior> create(const PlayScene& play, osgViewer::View& view,
                                                 const ChannelRig& rig);

    InteriorView& view() { return *_view; }
    const InteriorView& view() const { return *_view; }

    /// Sets the altimeter to another pressure, 940 to 1060 hPa, and returns it.
    double turnAltimeter(double hpa);

    /// `entities`: as they are shown. `motion`: what moves the watched one; null: the player.
    void update(const PlayScene& play, const simulation::ScenarioPlayer& player,
                const std::vector<simulation::EntityState>& entities,
                const simulation::ExternalMotion* motion, const Picture& picture);

private:
    explicit SceneInterior(std::unique_ptr<InteriorView> view) : _view(std::move(view)) {}

    std::unique_ptr<InteriorView> _view;
    bool _flies = false;
    double _seaHeightM = 0.0, _altimeterHpa = 1013.0;
};

/// The eye with its head bent, upwards for a positive angle.
scenery::Pose bent(const scenery::Pose& eye, double upDeg);

} // namespace trainer
