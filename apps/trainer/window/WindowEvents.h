// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgGA/GUIEventHandler>

#include "input/SeatKeys.h"
#include "window/SeatCamera.h"

namespace trainer
{

/// Hands the events of a window to the keys and to the camera. Threads: the event traversal.
class WindowEvents : public osgGA::GUIEventHandler
{
public:
    /// All must outlive it.
    WindowEvents(SeatKeys& keys, SeatCamera& camera) : _keys(keys), _camera(camera) {}

    bool handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action) override;

private:
    void drag(const osgGA::GUIEventAdapter& event);

    SeatKeys& _keys;
    SeatCamera& _camera;
    float _lastX = 0.0F, _lastY = 0.0F;
};

} // namespace trainer
