// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace simulation
{

/// One figure of a vehicle and what it has to be.
struct QualificationCheck
{
    std::string name;
    double value = 0.0;
    std::string unit;
    double expected = 0.0;
    double tolerance = 0.0; ///< in the value's unit
    std::string source;     ///< of the expected figure

    /// A figure that is not finite does not pass.
    bool passes() const { return std::abs(value - expected) <= tolerance; }
};

using QualificationChecks = std::vector<QualificationCheck>;

} // namespace simulation
