// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include "simulation/tour/RideConditions.h"

namespace CLI
{
class App;
}

namespace trainer
{

struct RideRequest;

/// The options that flights and drives share besides those of pictures: under which sky they go, and through
/// which traffic.
class RideOptions
{
public:
    /// Adds them to a command; this must outlive its parsing.
    void addTo(CLI::App& command);

    /// Writes them into a request. Errors: a time of day that is none, a density that is none.
    foundation::Outcome complete(RideRequest& request) const;

private:
    std::string _time, _traffic = "none";
    simulation::RideWeather _weather = simulation::RideWeather::clear;
};

} // namespace trainer
