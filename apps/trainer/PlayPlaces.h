// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "RideRequest.h"
#include "terminal/Places.h"

namespace trainer
{

/// What a play writes.
terminal::Places placesOf(const PlayRequest& request);

/// What a ride reads and writes besides what its play does.
terminal::Places placesOf(const RideRequest& request);

/// Tells before any work what is wrong with what a command line names: results that cannot be written, small files with faults, large ones
/// whose heads are wrong. Errors: those of checkPlaces(), readView(), readKeyScript(), readDevices(), checkScenery() and checkScene().
foundation::Outcome checkBeforePlay(const PlayRequest& request);

} // namespace trainer
