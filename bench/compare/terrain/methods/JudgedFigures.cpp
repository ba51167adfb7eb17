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
    const auto isHeld = [=](double figure) { return figure >= holds.least && figure <= holds.most; };
    const std::string verdict = std::all_of(figures.begin(), figures.end(), isHeld)    ? "confirmed"
                                : std::none_of(figures.begin(), figures.end(), isHeld) ? "refuted"
                                                                                       : "mixed";
    const std::string range =
        *lowest == *highest ? figureText(*lowest) : figureText(*lowest) + " to " + figureText(*highest);
    return {verdict, range + unit};
}

} // namespace terraintool
