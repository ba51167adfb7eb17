// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osgViewer/GraphicsWindow>

namespace trainer
{

/// What happens to a window that OSG's events do not tell: it loses the focus of the keyboard, is minimised,
/// or is destroyed by others. By a connection of its own to the display. Threads: one.
class WindowWatch
{
public:
    struct State
    {
        bool hasLostFocus = false; ///< since the last look
        bool isHidden = false;     ///< minimised, or unmapped
        bool isGone = false;       ///< destroyed
    };

    /// A window of another system than X is never hidden.
    explicit WindowWatch(osgViewer::GraphicsWindow& window);
    ~WindowWatch();
    WindowWatch(const WindowWatch&) = delete;
    WindowWatch& operator=(const WindowWatch&) = delete;

    State look();

private:
    struct Connection;
    std::unique_ptr<Connection> _connection; ///< null: nothing is watched
    State _state;
};

} // namespace trainer
