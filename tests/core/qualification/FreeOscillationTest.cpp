// SPDX-License-Identifier: Apache-2.0
#include "simulation/qualification/FreeOscillation.h"

#include <cmath>

#include <gtest/gtest.h>

namespace
{

using namespace simulation;

/// A swing of given period and damping about a drift.
Flight swinging(double periodS, double damping, double driftPerS)
{
    Flight flight;
    const double decay = 2.0 * 3.14159265 / periodS * damping / std::sqrt(1.0 - damping * damping);
    for (int i = 0; i < 3000; ++i)
    {
        FlightRow row;
        const double time = i / 30.0;
        row[FlightChannel::time] = time;
        row[FlightChannel::pitch] =
            std::exp(-decay * time) * std::cos(2.0 * 3.14159265 * time / periodS) + driftPerS * time;
        flight.push_back(row);
    }
    return flight;
}

TEST(FreeOscillationTest, FindsPeriodAndDamping)
{
    for (const double damping : {0.02, 0.11, 0.2})
    {
        const auto found = freeOscillation(swinging(26.0, damping, 0.0), FlightChannel::pitch, {0.0, 100.0});
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->periodS, 26.0, 0.1);
        EXPECT_NEAR(found->damping, damping, 0.01 * damping + 1e-3);
    }
}

TEST(FreeOscillationTest, ADriftDoesLittleHarm)
{
    const auto found = freeOscillation(swinging(26.0, 0.05, 0.002), FlightChannel::pitch, {0.0, 100.0});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->periodS, 26.0, 0.3);
    EXPECT_NEAR(found->damping, 0.05, 0.005);
}

TEST(FreeOscillationTest, WhatDoesNotSwingHasNone)
{
    EXPECT_FALSE(freeOscillation(swinging(26.0, 0.9, 0.1), FlightChannel::pitch, {0.0, 100.0}));
    EXPECT_FALSE(freeOscillation({}, FlightChannel::pitch, {0.0, 100.0}));
}

} // namespace
