// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/FlightInputs.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

double inputOf(const FlightInputs& inputs, FlightInput input)
{
    const double value = inputs[static_cast<std::size_t>(input)];
    if (std::isnan(value)) return 0.0;
    return std::clamp(value, input < FlightInput::flaps ? -1.0 : 0.0, 1.0);
}

double trimmedInputOf(const FlightInputs& inputs, FlightInput input, FlightInput trim)
{
    return std::clamp(inputOf(inputs, input) + inputOf(inputs, trim), -1.0, 1.0);
}

} // namespace simulation
