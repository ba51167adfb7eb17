// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/CompareMarkdown.h"

#include "compare/terrain/methods/FigureColumns.h"
#include "compare/terrain/methods/Verdicts.h"
#include "measurement/HtmlPage.h"

namespace terraintool
{

namespace
{

using measurement::figureText;
using Cells = std::vector<std::string>;

std::string rowOf(const Cells& cells)
{
    std::string row = "|";
    for (const std::string& cell : cells)
        row += " " + cell + " |";
    return row + "\n";
}

std::string headOf(const Cells& titles)
{
    std::string rule = "|";
    for (std::size_t i = 0; i < titles.size(); ++i)
        rule += "---|";
    return "\n" + rowOf(titles) + rule + "\n";
}

std::string figuresOf(const std::vector<DemComparison>& dems, const std::vector<FigureColumn>& columns)
{
    Cells titles{"raster", "method"};
    for (const FigureColumn& column : columns)
        titles.emplace_back(column.title);
    std::string table = headOf(titles);
    for (const DemComparison& dem : dems)
        for (const MethodFigures& m : dem.methods)
        {
            Cells cells{&m == &dem.methods.front() ? dem.dem : "", m.name};
            for (const FigureColumn& column : columns)
                cells.push_back(column.text(m));
            table += rowOf(cells);
        }
    return table;
}

std::string markOf(const std::string& verdict)
{
    return verdict == "met" ? "+" : verdict == "not met" ? "−" : "·";
}

/// A row for each requirement, a column for each method; in it a mark for each terrain.
std::string requirementsOf(const std::vector<DemComparison>& dems)
{
    if (dems.empty()) return "";
    std::vector<std::vector<RequirementVerdict>> verdicts;
    for (const DemComparison& dem : dems)
        verdicts.push_back(requirementVerdicts(dem));
    const std::size_t methods = dems[0].methods.size(), requirements = verdicts[0].size() / methods;
    Cells titles{""};
    for (const MethodFigures& m : dems[0].methods)
        titles.push_back(m.name);
    std::string table = headOf(titles);
    for (std::size_t r = 0; r < requirements; ++r)
    {
        Cells cells{verdicts[0][r].requirement};
        for (std::size_t m = 0; m < methods; ++m)
        {
            std::string marks;
            for (const auto& ofDem : verdicts)
                marks += (marks.empty() ? "" : " ") + markOf(ofDem[m * requirements + r].verdict);
            cells.push_back(marks);
        }
        table += rowOf(cells);
    }
    return table;
}

/// What each method did at as many triangles as ROAM drew.
std::string ceilingsOf(const std::vector<DemComparison>& dems)
{
    std::string table = headOf({"raster", "method", "what it did"});
    for (const DemComparison& dem : dems)
        for (const RequirementVerdict& v : requirementVerdicts(dem))
            if (v.requirement == "R7" && dem.of(v.method)->ceiling)
                table += rowOf({dem.dem, v.method, v.figure});
    return table;
}

std::string reworksOf(const std::vector<DemComparison>& dems)
{
    std::string table = headOf({"raster", "frames", "way", "µs", "worst"});
    for (const DemComparison& dem : dems)
        for (const ReworkFigures& r : dem.reworks)
            table += rowOf({dem.dem, r.path, r.way, figureText(r.adaptUsP50), figureText(r.adaptUsMax)});
    return table;
}

} // namespace

std::string comparisonMarkdown(const std::vector<DemComparison>& dems)
{
    std::string claims = headOf({"claim", "verdict", "figure"});
    for (const ClaimVerdict& v : claimVerdicts(dems))
        claims += rowOf({v.claim, v.verdict, v.figure});
    std::string qualities = headOf({"section", "method", "", "", "verdict", "figure"});
    for (const QualityVerdict& v : qualityVerdicts(dems))
        qualities += rowOf({v.section, v.method, v.kind, v.quality, v.verdict, v.figure});
    return "## Figures\n" + figuresOf(dems, figureColumns()) + figuresOf(dems, furtherFigureColumns()) +
           "\n## Requirements\n\nVerdicts on the rasters, in their order: + met, − not met, · not "
           "measured.\n" +
           requirementsOf(dems) + "\nAt as many triangles as ROAM drew (R7):\n" + ceilingsOf(dems) +
           "\n## Frames that have little in common\n" + reworksOf(dems) + "\n## Claims of the paper\n" +
           claims + "\n## Advantages and drawbacks that it lists\n" + qualities;
}

} // namespace terraintool
