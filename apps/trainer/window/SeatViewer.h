// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <osgViewer/Viewer>

namespace trainer
{

/// A viewer that does something between reading events and updating the scene: a key is in the picture of the frame that reads it.
class SeatViewer : public osgViewer::Viewer
{
public:
    explicit SeatViewer(std::function<void()> afterEvents) : _afterEvents(std::move(afterEvents)) {}

    void eventTraversal() override
    {
        osgViewer::Viewer::eventTraversal();
        if (!done()) _afterEvents();
    }

private:
    std::function<void()> _afterEvents;
};

} // namespace trainer
