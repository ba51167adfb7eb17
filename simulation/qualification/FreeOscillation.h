// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/qualification/FlightReplay.h"

namespace simulation
{

/// A motion that swings freely.
struct FreeOscillation
{
    double periodS = 0.0;
    double damping = 0.0; ///< over the critical one
};

/// Period and damping of a channel's swings in a window, from the spacing of its turning points and the
/// decrement of the swings between them; a drift much slower than the swings does no harm. Nothing where
/// there are fewer than three swings.
/// Source: Etkin, Reid, *Dynamics of Flight*, 3rd edition, 1996, section 6 (time to half and logarithmic
/// decrement).
std::optional<FreeOscillation> freeOscillation(const Flight& flight, FlightChannel channel,
                                               const FlightWindow& window);

} // namespace simulation
