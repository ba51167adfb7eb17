// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "simulation/parser/ElementReader.h"
#include "simulation/parser/RandomDraw.h"

namespace simulation
{

/// Values for some parameters, each with the name of its parameter.
using ParameterValues = std::vector<std::pair<std::string, std::string>>;

/// Returns the values of one deterministic distribution, in order: of a single parameter, or of several
/// together. Problems go to the context; a distribution that is not read returns no values.
std::vector<ParameterValues> parseDeterministic(ElementReader distribution);

/// The distribution of one parameter that is left to chance.
struct StochasticDistribution
{
    std::string parameter;
    std::function<std::string(RandomDraw&)> draw; ///< empty: not read
};

StochasticDistribution parseStochastic(ElementReader distribution);

} // namespace simulation
