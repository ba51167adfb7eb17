// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "ride/RideRequest.h"
#include "terminal/Places.h"

namespace trainer
{

/// What a play writes.
terminal::Places placesOf(const PlayRequest& request);

/// What a ride reads and writes besides what its play does.
terminal::Places placesOf(const RideRequest& request);

/// Tells before any work what is wrong with what a command line names: results that cannot be written, small
/// files with faults, no display for a window, large files whose heads are wrong.
/// Errors: those of checkPlaces(), readView(), readKeyScript(), readDevices(), checkScenery(), checkDisplay()
/// and checkScene().
foundation::Outcome checkBeforePlay(const PlayRequest& request);

/// The same of a ride. Errors: those of checkPlaces(), and of checkDisplay() where it opens a window.
foundation::Outcome checkBeforeRide(const RideRequest& request);

} // namespace trainer
