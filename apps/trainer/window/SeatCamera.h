// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "play/OwnshipEye.h"
#include "play/PlayScene.h"
#include "play/SceneInterior.h"
#include "view/Channel.h"

namespace trainer
{

/// The eye of a window: a view that keys change, and a head that turns in it. Frame: world. Threads: one.
class SeatCamera
{
public:
    /// `play`: with its player; it must outlive this.
    SeatCamera(PlayScene& play, const FrameRequest& frames);

    /// Takes a view of kSeatViews, counted; another number is the next one.
    void setView(std::size_t view);
    std::size_t view() const { return _view; }
    void nextView();

    /// The way to look from the view's own. Degrees to the left.
    void glance(double leftDeg) { _glanceDeg = leftDeg; }

    /// Turns the head, or the free eye: degrees to the left and upwards.
    void turn(double leftDeg, double upDeg);

    /// How the head is bent where it looks straight ahead: degrees upwards.
    void bend(double upDeg) { _bentDeg = upDeg; }

    /// Whether the head reads the instruments, and where they are: a picture of them alone, from the same
    /// seat.
    void readPanel(bool reads, const scenery::models::PanelView& panel)
    {
        _reads = reads;
        _panel = panel;
    }
    bool readsPanel() const { return _reads && isInside(); }

    /// The middle of the picture is shown so many times as large, as through binoculars.
    void zoom(double factor) { _zoom = factor; }

    /// The height of the picture, with or without an interior around the eye. Units: degrees.
    double pictureDeg(bool hasInterior) const
    {
        const double insideDeg = readsPanel() ? _panel.heightDeg : SceneInterior::kPictureDeg;
        return zoomedDeg(hasInterior ? insideDeg : kPictureDeg, _zoom);
    }

    /// Moves the head in its seat while this is not 0: metres a second along an axis of the vehicle. It stays
    /// within reach of its place.
    void lean(int axis, double mps) { _leanMps[axis] = mps; }

    /// The head looks straight ahead from its place again.
    void straighten();

    /// Moves the free eye ahead, or takes the map nearer. `notches`: of a wheel.
    void move(double notches);

    /// The camera for a state of the ownship, `dtS` after the last one.
    scenery::Pose update(const simulation::EntityState& ownship, double dtS);

    /// Begins the view anew: the ownship was put elsewhere.
    void restart() { setView(_view); }

    double nearM() const { return isInside() ? kNearFromInsideM : nearPlaneM(_ownship, _frames.eye); }
    bool isInside() const { return _frames.isInside(); }
    bool isMap() const { return _frames.eye == EyePoint::map; }
    double mapHeightM() const { return _eye->mapHeightM(); }

private:
    PlayScene& _play;
    simulation::ScenarioObject _ownship;
    TrainSize _train; ///< asked for at the beginning: the player goes to whoever steps it
    FrameRequest _frames;
    std::unique_ptr<OwnshipEye> _eye;
    std::size_t _view = 0;
    scenery::models::PanelView _panel;
    bool _reads = false;
    double _zoom = 1.0;
    double _glanceDeg = 0.0, _turnedDeg = 0.0, _raisedDeg = 0.0, _bentDeg = 0.0;
    glm::dvec3 _head{0.0}, _leanMps{0.0}; ///< from its place; vehicle's frame
    scenery::Pose _last;
};

} // namespace trainer
