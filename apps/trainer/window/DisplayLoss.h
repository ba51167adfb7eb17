// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace trainer
{

/// As long as it lives, a display that goes away (its server is killed, its connection breaks) leads to `save` and the end of the process with
/// a message and exit code 1; Xlib itself would end it with nothing written. Threads: one of it in a process.
class DisplayLoss
{
public:
    explicit DisplayLoss(std::function<void()> save);
    ~DisplayLoss();
    DisplayLoss(const DisplayLoss&) = delete;
    DisplayLoss& operator=(const DisplayLoss&) = delete;
};

} // namespace trainer
