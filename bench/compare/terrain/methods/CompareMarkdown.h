// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/terrain/methods/MethodFigures.h"

namespace terraintool
{

/// Makes the tables of a comparison as Markdown, for documentation: figures and verdicts of all terrains,
/// side by side, without plots.
std::string comparisonMarkdown(const std::vector<DemComparison>& dems);

} // namespace terraintool
