// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace trainer
{

/// The units of the head-up display.
enum class HudUnits
{
    usual,   ///< of aircraft knots and feet, of road vehicles km/h
    metric,  ///< km/h, metres, m/s
    imperial ///< mph on roads; of aircraft knots and feet
};

} // namespace trainer
