// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/JudgedFigures.h"

#include <algorithm>

#include "measurement/HtmlPage.h"

namespace terraintool
{

JudgedFigures judgeFigures(const std::vector<double>& figures, HeldRange holds, const std::string& unit)
{
    using measurement::figureText;
    if (figures.empty()) return {"not measured", "no figure"};
    const auto [lowest, highest] = std::minmax_element(figures.begin(), figures.end());
    const bool isHeld = *lowest >= holds.least && *highest <= holds.most;
    const std::string range =
        *lowest == *highest ? figureText(*lowest) : figureText(*lowest) + " to " + figureText(*highest);
    return {isHeld ? "confirmed" : "refuted", range + unit};
}

} // namespace terraintool
