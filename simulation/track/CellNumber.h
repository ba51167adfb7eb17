// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace simulation
{

/// A number and the letters around it.
struct CellNumber
{
    double value = 0.0;
    std::string before, behind; ///< in capitals
};

/// Reads 9.5, 9,5, 1,640.42, 1.640,42, 48.5N, 500 ft. `isDecimalComma`: in the other cells. Nothing: there is
/// no number, or something else with it.
std::optional<CellNumber> cellNumber(std::string_view cell, bool isDecimalComma);

} // namespace simulation
