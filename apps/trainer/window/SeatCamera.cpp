// SPDX-License-Identifier: Apache-2.0
#include "window/SeatCamera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Angle.h>
#include <glm/gtc/matrix_transform.hpp>

#include "input/KeyTable.h"

namespace trainer
{

namespace
{

// In the order of kSeatViews.
constexpr std::array kViewEyes{EyePoint::own,  EyePoint::chase, EyePoint::above, EyePoint::tower,
                               EyePoint::kerb, EyePoint::free,  EyePoint::map};
static_assert(kViewEyes.size() == std::size(kSeatViews));

constexpr double kAboveInstrumentsM = 70.0;          ///< so steep that the instruments do not hide the car
constexpr double kReachM = 0.25, kHeadNotchM = 0.02; ///< of a head in its seat
constexpr double kMostUpDeg = 80.0, kMoveM = 2.0, kZoom = 1.25, kLowestMapM = 100.0, kHighestMapM = 30'000.0;

glm::dmat3 rotated(const glm::dmat3& frame, double leftDeg, double upDeg)
{
    glm::dmat4 turned =
        glm::rotate(glm::dmat4(1.0), foundation::radiansOf(leftDeg), glm::dvec3(0.0, 0.0, 1.0));
    turned = glm::rotate(turned, -foundation::radiansOf(upDeg), glm::dvec3(0.0, 1.0, 0.0));
    return frame * glm::dmat3(turned);
}

/// A view's place in kSeatViews; driver and pilot are one.
std::size_t viewOfEye(EyePoint eye)
{
    const auto found = std::find(kViewEyes.begin(), kViewEyes.end(), eye);
    return found == kViewEyes.end() ? 0 : static_cast<std::size_t>(found - kViewEyes.begin());
}

} // namespace

SeatCamera::SeatCamera(PlayScene& play, const FrameRequest& frames)
    : _play(play),
      _ownship(play.ownship()),
      _train(trainOf(play.player->scenario(), play.watched)),
      _frames(frames)
{
    setView(viewOfEye(frames.eye));
}

void SeatCamera::setView(std::size_t view)
{
    const bool hasBeen = _eye != nullptr;
    _view = view % kViewEyes.size();
    _frames.eye = kViewEyes[_view];
    _play.setEye(_frames.eye);
    if (hasBeen) _frames.eyeHeightM.reset(); // that of the command line was for its own view
    if (_frames.eye == EyePoint::above && !_frames.eyeHeightM) _frames.eyeHeightM = kAboveInstrumentsM;
    _turnedDeg = _raisedDeg = 0.0;
    _eye = std::make_unique<OwnshipEye>(_ownship, _train, _play.scene->eyeIn(_play.watched), _frames,
                                        _play.terrain.ground());
    if (hasBeen) _eye->setFree(_last);
    _play.scene->hide(_play.watched, _frames.isInside());
}

void SeatCamera::nextView()
{
    setView(_view + 1);
}

void SeatCamera::turn(double leftDeg, double upDeg)
{
    _turnedDeg = std::remainder(_turnedDeg + leftDeg, 360.0);
    _raisedDeg = std::clamp(_raisedDeg + upDeg, -kMostUpDeg, kMostUpDeg);
}

void SeatCamera::straighten()
{
    _turnedDeg = _raisedDeg = 0.0;
    _head = glm::dvec3(0.0);
}

void SeatCamera::move(double notches)
{
    if (isInside()) _head.x = std::clamp(_head.x + kHeadNotchM * notches, -kReachM, kReachM);
    if (isMap())
        _eye->setMapHeight(
            std::clamp(_eye->mapHeightM() * std::pow(kZoom, -notches), kLowestMapM, kHighestMapM));
    if (_frames.eye != EyePoint::free) return;
    _last.positionWorld += notches * kMoveM * _last.forward();
    _eye->setFree(_last);
}

scenery::Pose SeatCamera::update(const simulation::EntityState& ownship, double dtS)
{
    scenery::Pose pose = _eye->update(ownship, dtS);
    if (isMap()) return _last = pose;
    if (_frames.eye == EyePoint::free && (_turnedDeg != 0.0 || _raisedDeg != 0.0))
    {
        // The free eye keeps its turn, and its horizon level.
        const double heading =
            foundation::degreesOf(std::atan2(pose.forward().y, pose.forward().x)) + _turnedDeg;
        const double pitch =
            foundation::degreesOf(std::asin(std::clamp(pose.forward().z, -1.0, 1.0))) + _raisedDeg;
        pose.worldFromBody = rotated(glm::dmat3(1.0), heading, std::clamp(pitch, -kMostUpDeg, kMostUpDeg));
        _turnedDeg = _raisedDeg = 0.0;
        _eye->setFree(pose);
    }
    _last = pose;
    if (isInside())
    {
        _head = glm::clamp(_head + dtS * _leanMps, -kReachM, kReachM);
        pose.positionWorld += pose.worldFromBody * _head;
    }
    if (readsPanel())
    {
        pose.worldFromBody = rotated(pose.worldFromBody, _panel.leftDeg, _panel.upDeg);
        return pose;
    }
    const double bentDeg = isInside() ? _bentDeg : 0.0;
    if (_frames.eye != EyePoint::free)
        pose.worldFromBody = rotated(pose.worldFromBody, _turnedDeg + _glanceDeg, _raisedDeg + bentDeg);
    return pose;
}

} // namespace trainer
