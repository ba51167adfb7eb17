// SPDX-License-Identifier: Apache-2.0
#include "window/WindowEvents.h"

namespace trainer
{

namespace
{

constexpr double kDegPerPx = 0.2;

} // namespace

bool WindowEvents::handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& /*action*/)
{
    switch (event.getEventType())
    {
    case osgGA::GUIEventAdapter::KEYDOWN:
        _keys.press(event.getUnmodifiedKey() != 0 ? event.getUnmodifiedKey() : event.getKey());
        return true;
    case osgGA::GUIEventAdapter::KEYUP:
        _keys.release(event.getUnmodifiedKey() != 0 ? event.getUnmodifiedKey() : event.getKey());
        return true;
    case osgGA::GUIEventAdapter::PUSH:
        _lastX = event.getX();
        _lastY = event.getY();
        return true;
    case osgGA::GUIEventAdapter::DRAG:
        drag(event);
        return true;
    case osgGA::GUIEventAdapter::SCROLL:
        if (event.getScrollingMotion() == osgGA::GUIEventAdapter::SCROLL_UP) _camera.move(1.0);
        if (event.getScrollingMotion() == osgGA::GUIEventAdapter::SCROLL_DOWN) _camera.move(-1.0);
        return true;
    default:
        return false;
    }
}

/// The scene follows the mouse.
void WindowEvents::drag(const osgGA::GUIEventAdapter& event)
{
    const double up =
        event.getMouseYOrientation() == osgGA::GUIEventAdapter::Y_INCREASING_UPWARDS ? 1.0 : -1.0;
    _camera.turn(kDegPerPx * (event.getX() - _lastX), -up * kDegPerPx * (event.getY() - _lastY));
    _lastX = event.getX();
    _lastY = event.getY();
}

} // namespace trainer
