// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "ride/FlyRequest.h"

namespace trainer
{

/// Tells before any work, and before a world is made, what is wrong with a flight besides its pictures.
/// Errors: of files that cannot be read or written, of the aircraft's file, of orders.
foundation::Outcome checkFlight(const FlyRequest& request);

/// Flies an aircraft by its own physics over a world: by the autopilot or by recorded inputs, with or without
/// pictures, or by hand in a window. Prints how it ended. Errors: those of the files, of the world, of the
/// start (in water, in the ground).
foundation::Outcome fly(const FlyRequest& request);

} // namespace trainer
