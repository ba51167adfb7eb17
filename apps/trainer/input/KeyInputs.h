// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "simulation/control/ManualController.h"

namespace trainer
{

// What keys do to the inputs under manual control. An input that the vehicle has not is left out.

/// Pushes an input up (1), down (-1), or not (0). "brakes" stands for both brakes.
void holdInput(simulation::ManualController& manual, std::string_view input, double direction);

/// Moves it by an amount, within its range.
void addToInput(simulation::ManualController& manual, std::string_view input, double amount);

/// Puts it to the other end of its range.
void flipInput(simulation::ManualController& manual, std::string_view input);

} // namespace trainer
