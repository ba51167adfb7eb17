// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "compare/terrain/methods/MethodFigures.h"

namespace terraintool
{

/// Makes the table of a comparison (docs/reference/json-tables.md), with the verdicts.
nlohmann::ordered_json comparisonJson(const std::vector<DemComparison>& dems);

} // namespace terraintool
