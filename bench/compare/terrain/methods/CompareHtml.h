// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/terrain/methods/MethodFigures.h"

namespace terraintool
{

/// Makes the report of a comparison, a page that needs no network: the verdicts of claims, and for each
/// terrain figures, the verdicts of requirements, and plots over the frames.
/// `pictures`: the folder of the pictures, as seen from the page.
std::string comparisonHtml(const std::vector<DemComparison>& dems, const std::string& pictures = "");

/// The folder for the pictures of a report, beside it: "three-pictures" for "three.html".
std::string picturesOf(const std::filesystem::path& html);

} // namespace terraintool
