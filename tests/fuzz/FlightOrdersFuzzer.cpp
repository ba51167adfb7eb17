// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as orders of an autopilot: they are read as finite numbers, or refused.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "simulation/control/flight/FlightOrders.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto orders =
        simulation::parseFlightOrders(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    if (!orders) return 0;
    if (orders->empty()) std::abort();
    for (const simulation::FlightOrder& order : *orders)
        if (!std::isfinite(order.value)) std::abort();
    return 0;
}
