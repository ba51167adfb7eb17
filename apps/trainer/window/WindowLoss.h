// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <osgViewer/GraphicsWindow>

namespace trainer
{

/// As long as it lives, a window that another program destroys, or a display that goes away (its server is
/// killed, its connection breaks), leads to `save` and the end of the process with a message and exit code 1
/// (decision 54). Threads: one of it in a process.
class WindowLoss
{
public:
    /// `save` may not speak with the display.
    WindowLoss(osgViewer::GraphicsWindow& window, std::function<void()> save);
    ~WindowLoss();
    WindowLoss(const WindowLoss&) = delete;
    WindowLoss& operator=(const WindowLoss&) = delete;

    /// What it leads to, for those who find the window gone. No destructor runs.
    [[noreturn]] static void endWithoutWindow();
};

} // namespace trainer
