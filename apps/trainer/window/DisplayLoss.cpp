// SPDX-License-Identifier: Apache-2.0
#include "window/DisplayLoss.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include <X11/Xlib.h>

#include "terminal/Terminal.h"

namespace trainer
{

namespace
{

std::function<void()>& saving()
{
    static std::function<void()> save;
    return save;
}

XIOErrorHandler& handlerBefore()
{
    static XIOErrorHandler before = nullptr;
    return before;
}

/// Xlib ends the process when this returns. Nothing that speaks with the display may run any more, no destructor of a window either.
int whenLost(Display* /*display*/)
{
    if (const auto save = std::exchange(saving(), {})) save();
    std::fflush(nullptr);
    const int code =
        terminal::fail("trainer", foundation::Error{"--window", "the display has gone away",
                                                    "what was recorded is written; begin again"});
    std::_Exit(code);
}

} // namespace

DisplayLoss::DisplayLoss(std::function<void()> save)
{
    saving() = std::move(save);
    handlerBefore() = XSetIOErrorHandler(whenLost);
}

DisplayLoss::~DisplayLoss()
{
    saving() = {};
    XSetIOErrorHandler(handlerBefore());
}

} // namespace trainer
