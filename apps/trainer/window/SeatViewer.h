// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <osgViewer/Viewer>

namespace trainer
{

/// A viewer that does something between reading events and updating the scene: a key is in the picture of the
/// frame that reads it. Whoever reads pictures back hears of a window that closes while it can still be read.
class SeatViewer : public osgViewer::Viewer
{
public:
    SeatViewer(std::function<void()> afterEvents, std::function<void()> beforeClose)
        : _afterEvents(std::move(afterEvents)), _beforeClose(std::move(beforeClose))
    {
    }

    void eventTraversal() override
    {
        if (isClosing()) _beforeClose();
        osgViewer::Viewer::eventTraversal();
        if (!done()) _afterEvents();
    }

private:
    /// Whether the events that come next close a window.
    bool isClosing()
    {
        Windows windows;
        getWindows(windows);
        for (osgViewer::GraphicsWindow* const window : windows)
        {
            window->checkEvents();
            osgGA::EventQueue::Events events;
            window->getEventQueue()->copyEvents(events);
            for (const auto& event : events)
                if (const auto* const adapter = event->asGUIEventAdapter())
                    if (adapter->getEventType() == osgGA::GUIEventAdapter::CLOSE_WINDOW) return true;
        }
        return false;
    }

    std::function<void()> _afterEvents, _beforeClose;
};

} // namespace trainer
