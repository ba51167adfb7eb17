// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgViewer/GraphicsWindow>

#include "input/KeyPresser.h"
#include "input/KeyScript.h"
#include "simulation/control/ControlSwitch.h"
#include "simulation/vehicle/DynamicVehicle.h"

namespace trainer
{

/// Test aids that put events into the queue of a window, as if somebody pressed keys there: a key script, and
/// a simulated hand.
/// Threads: that of the viewer.
class InjectedEvents
{
public:
    /// `script`: in the order of time. `vehicle`: whose keys a simulated hand presses.
    InjectedEvents(const osg::ref_ptr<osgViewer::GraphicsWindow>& window, std::vector<WindowEvent> script,
                   KeyScope vehicle)
        : _window(window), _script(std::move(script)), _hand(vehicle)
    {
    }

    /// What the script has up to a time since the window opened.
    void playScript(double wallS);

    /// Lets the simulated hand press what its automatic wishes; Escape where that has done all. `nextS`:
    /// until the next picture.
    void moveHand(const simulation::ControlSwitch& manual, const simulation::DynamicVehicle& vehicle,
                  double nextS);

private:
    void send(int key, bool isDown);

    osg::ref_ptr<osgViewer::GraphicsWindow> _window;
    std::vector<WindowEvent> _script;
    std::size_t _played = 0; ///< of its events
    KeyPresser _hand;
};

} // namespace trainer
