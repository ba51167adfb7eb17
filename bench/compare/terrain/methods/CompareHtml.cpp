// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/CompareHtml.h"

#include <array>

#include "compare/terrain/methods/FigureColumns.h"
#include "compare/terrain/methods/Verdicts.h"
#include "measurement/HtmlPage.h"
#include "measurement/SvgPlot.h"

namespace terraintool
{

namespace
{

using measurement::escapedMarkup;
using measurement::figureText;

constexpr std::array kColours{"#1f6feb", "#0a7d4f", "#b4451f", "#7a3fb0", "#7a5c00",
                              "#00738a", "#c02a4a", "#4d5663", "#8a4b00", "#2f6d1c"};

std::string figuresTable(const DemComparison& dem, const std::vector<FigureColumn>& columns)
{
    std::string html = "<table>\n<tr><th>method</th>";
    for (const FigureColumn& column : columns)
        html += std::string("<th class=\"number\">") + column.title + "</th>";
    html += "</tr>\n";
    for (const MethodFigures& m : dem.methods)
    {
        html += "<tr><td>" + escapedMarkup(m.name) + "</td>";
        for (const FigureColumn& column : columns)
            html += "<td class=\"number\">" + column.text(m) + "</td>";
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

std::string reworksTable(const DemComparison& dem)
{
    std::string html = "<table>\n<tr><th>frames that have little in common</th><th>way</th>"
                       "<th class=\"number\">µs</th><th class=\"number\">worst</th></tr>\n";
    for (const ReworkFigures& r : dem.reworks)
        html += "<tr><td>" + escapedMarkup(r.path) + "</td><td>" + escapedMarkup(r.way) +
                "</td><td class=\"number\">" + figureText(r.adaptUsP50) + "</td><td class=\"number\">" +
                figureText(r.adaptUsMax) + "</td></tr>\n";
    return html + "</table>\n";
}

std::string qualitiesTable(const std::vector<DemComparison>& dems)
{
    std::string html = "<table>\n<tr><th>section</th><th>method</th><th></th><th></th><th>verdict</th>"
                       "<th>figure</th></tr>\n";
    for (const QualityVerdict& v : qualityVerdicts(dems))
    {
        html += "<tr>";
        for (const std::string& text : {v.section, v.method, v.kind, v.quality, v.verdict, v.figure})
            html += "<td>" + escapedMarkup(text) + "</td>";
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

std::string requirementsTable(const DemComparison& dem)
{
    std::string html = "<table>\n<tr><th></th><th>method</th><th>verdict</th><th>figure</th></tr>\n";
    for (const RequirementVerdict& v : requirementVerdicts(dem))
        html += "<tr><td>" + v.requirement + "</td><td>" + escapedMarkup(v.method) + "</td><td>" + v.verdict +
                "</td><td>" + escapedMarkup(v.figure) + "</td></tr>\n";
    return html + "</table>\n";
}

std::string claimsTable(const std::vector<DemComparison>& dems)
{
    std::string html = "<table>\n<tr><th>claim</th><th>verdict</th><th>figure</th></tr>\n";
    for (const ClaimVerdict& v : claimVerdicts(dems))
        html += "<tr><td>" + escapedMarkup(v.claim) + "</td><td>" + v.verdict + "</td><td>" +
                escapedMarkup(v.figure) + "</td></tr>\n";
    return html + "</table>\n";
}

/// Pictures of all methods from the same eye, side by side; nothing where none was written.
std::string picturesTable(const DemComparison& dem, const std::string& folder)
{
    std::string images, names;
    for (const MethodFigures& m : dem.methods)
    {
        if (m.picture.empty()) continue;
        images += "<td><img src=\"" + escapedMarkup(folder + "/" + m.picture) + "\" alt=\"" +
                  escapedMarkup(m.name) + "\" width=\"240\"></td>";
        names += "<th>" + escapedMarkup(m.name) + "</th>";
    }
    if (images.empty()) return "";
    return "<p>From the middle of the flight, at four times the tolerances.</p>\n<table>\n<tr>" + names +
           "</tr>\n<tr>" + images + "</tr>\n</table>\n";
}

/// Plots one list of figures of each method over the frames.
std::string plotOf(const DemComparison& dem, const char* title, std::vector<double> MethodFigures::*values)
{
    measurement::Plot plot{title, "frame", {}, {}};
    for (const MethodFigures& m : dem.methods)
    {
        if ((m.*values).empty()) continue;
        plot.series.push_back({m.name, kColours[plot.series.size() % kColours.size()], m.*values});
        for (std::size_t frame = plot.x.size(); frame < (m.*values).size(); ++frame)
            plot.x.push_back(static_cast<double>(frame + 1));
    }
    return measurement::svgPlot(plot);
}

} // namespace

std::string picturesOf(const std::filesystem::path& html)
{
    return html.stem().string() + "-pictures";
}

std::string comparisonHtml(const std::vector<DemComparison>& dems, const std::string& pictures)
{
    std::string html = "<h2>Claims of the paper</h2>\n" + claimsTable(dems) +
                       "<h2>Advantages and drawbacks that it lists</h2>\n" + qualitiesTable(dems);
    for (const DemComparison& dem : dems)
        html += "<h2>" + escapedMarkup(dem.dem) + "</h2>\n" + picturesTable(dem, pictures) +
                figuresTable(dem, figureColumns()) + figuresTable(dem, furtherFigureColumns()) +
                reworksTable(dem) + plotOf(dem, "Triangles", &MethodFigures::frameTriangles) +
                plotOf(dem, "Adaptation, µs", &MethodFigures::frameUs) + requirementsTable(dem);
    return measurement::htmlPage("Methods of level of detail at equal true error", html);
}

} // namespace terraintool
