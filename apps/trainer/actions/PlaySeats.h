// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <foundation/Result.h>

#include "request/PlayRequest.h"
#include "simulation/control/scenario/PersonSeat.h"
#include "simulation/scenario/Scenario.h"

namespace trainer
{

/// Who sits where in a scenario, and with what, before anything is opened. A seat without an entity is that
/// of the first manual controller of the storyboard, else `watched` (with a window; empty: without). Nothing:
/// the scenario has no manual controller, and nobody asked for more.
/// Errors: an entity that there is not, or that nobody can drive, with those that there are; files of the
/// vehicle and the inputs; inputs, or a file for them, without an entity.
foundation::Result<std::optional<SeatRequest>> seatFor(const simulation::Scenario& scenario,
                                                       const SeatRequest& asked, const std::string& watched);

/// Errors: a person is asked for, but there is neither a window nor recorded inputs.
foundation::Outcome checkHands(const SeatRequest& seat, bool hasWindow);

/// Tells that recorded inputs without a gear leave a car in neutral. Errors: as readInputs().
foundation::Outcome tellInputs(const std::filesystem::path& file);

/// Writes what was done in a seat; an empty path: nothing. Errors: a file that cannot be written.
foundation::Outcome writeRecorded(const simulation::PersonSeat& seat, const std::filesystem::path& file,
                                  double timeS);

} // namespace trainer
