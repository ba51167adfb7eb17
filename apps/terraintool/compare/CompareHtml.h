// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "terraintool/compare/MethodFigures.h"

namespace terraintool
{

/// Makes the report of a comparison, a page that needs no network: the verdicts of claims, and for each terrain figures, the
/// verdicts of requirements, and plots over the frames.
std::string comparisonHtml(const std::vector<DemComparison>& dems);

} // namespace terraintool
