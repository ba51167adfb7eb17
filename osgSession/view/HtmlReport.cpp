// SPDX-License-Identifier: Apache-2.0
#include "view/HtmlReport.h"

#include <cmath>

#include <foundation/WholeFile.h>

#include "measurement/HtmlPage.h"
#include "measurement/SvgPlot.h"

namespace trainer
{

using measurement::escapedMarkup;
using measurement::figureText;
using measurement::PlotSeries;
using measurement::svgPlot;

namespace
{

std::string factsTable(const ReportContent& content)
{
    std::string html = "<table>\n";
    for (const auto& [name, value] : content.facts)
        html += "<tr><th>" + escapedMarkup(name) + "</th><td>" + escapedMarkup(value) + "</td></tr>\n";
    return html + "</table>\n";
}

std::string summaryTable(const std::vector<FrameStatistics>& frames)
{
    std::string html = "<table>\n<tr><th></th><th class=\"number\">first frame</th>"
                       "<th class=\"number\">median of the others</th><th class=\"number\">99 %</th>"
                       "<th class=\"number\">largest</th></tr>\n";
    for (const StatisticsColumn& column : statisticsColumns(frames))
    {
        const ColumnSummary summary = summaryOf(frames, column);
        html += "<tr><td>" + std::string(column.name) + (column.isMeasured ? " (measured)" : "") + "</td>";
        for (const double value : {summary.first, summary.median, summary.p99, summary.largest})
            html += "<td class=\"number\">" + (std::isfinite(value) ? figureText(value) : "none") + "</td>";
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

PlotSeries seriesOf(const std::vector<FrameStatistics>& frames, std::string_view name,
                    const std::string& colour)
{
    PlotSeries series{std::string(name), colour, {}};
    for (const StatisticsColumn& column : statisticsColumns(frames))
        if (column.name == name)
            for (const FrameStatistics& frame : frames)
                series.values.push_back(column.value(frame));
    return series;
}

std::string objectPlots(const std::vector<FrameStatistics>& frames, const std::string& x,
                        const std::vector<double>& times)
{
    std::string html =
        svgPlot({"Objects",
                 x,
                 times,
                 {seriesOf(frames, "objectsVisible", "#1f6feb"), seriesOf(frames, "objectsDrawn", "#0a7d4f"),
                  seriesOf(frames, "objectsSwitching", "#b4451f")}});
    html += svgPlot({"Triangles of objects", x, times, {seriesOf(frames, "objectTriangles", "#7a3fb0")}});
    return html + svgPlot({"Choosing objects, ms", x, times, {seriesOf(frames, "objectCullMs", "#7a5c00")}});
}

/// Returns the table of the selection methods, summed over all frames.
std::string methodsTable(const std::vector<FrameStatistics>& frames)
{
    using namespace osgPMObjects::core;
    std::string html = "<h2>Selection, all frames</h2>\n<table>\n<tr><th>method</th>";
    for (const char* head : {"objects", "switched", "full area", "faded", "gone", "triangles"})
        html += std::string("<th class=\"number\">") + head + "</th>";
    html += "</tr>\n";
    for (std::size_t i = 0; i < kSelectionMethods; ++i)
    {
        MethodStatistics sum;
        for (const FrameStatistics& frame : frames)
            if (frame.objects) sum += frame.objects->selection.byMethod[i];
        if (sum.objects == 0) continue;
        html += std::string("<tr><td>") + nameOf(static_cast<SelectionMethod>(i)) + "</td>";
        for (const std::uint64_t value :
             {std::uint64_t{sum.objects}, std::uint64_t{sum.switched}, std::uint64_t{sum.fullArea},
              std::uint64_t{sum.faded}, std::uint64_t{sum.gone}, sum.triangles})
            html += "<td class=\"number\">" + std::to_string(value) + "</td>";
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

std::string plots(const std::vector<FrameStatistics>& frames)
{
    std::vector<double> times;
    for (const FrameStatistics& frame : frames)
        times.push_back(frame.timeS);
    const std::string x = "simulated time, s";
    std::string html = svgPlot({"Triangles drawn", x, times, {seriesOf(frames, "triangles", "#1f6feb")}});
    html += svgPlot({"Changes per frame",
                     x,
                     times,
                     {seriesOf(frames, "splits", "#0a7d4f"), seriesOf(frames, "merges", "#b4451f")}});
    html += svgPlot({"Adaptation, µs", x, times, {seriesOf(frames, "adaptUs", "#7a3fb0")}});
    html += svgPlot({"Error bound, pixels", x, times, {seriesOf(frames, "maxErrorPx", "#c02a4a")}});
    if (!frames.empty() && frames.front().objects) html += objectPlots(frames, x, times);
    return html + svgPlot({"Cull and draw, ms",
                           x,
                           times,
                           {seriesOf(frames, "cullMs", "#7a5c00"), seriesOf(frames, "drawMs", "#00738a")}});
}

} // namespace

std::string reportHtml(const ReportContent& content, const std::vector<FrameStatistics>& frames)
{
    std::string html = factsTable(content);
    if (!content.video.empty())
        html += "<video controls loop muted src=\"" + escapedMarkup(content.video) + "\"></video>\n";
    if (!content.contactSheet.empty())
        html += "<h2>Pictures</h2>\n<img alt=\"Frames at equal intervals\" src=\"" +
                escapedMarkup(content.contactSheet) + "\">\n";
    html += "<h2>Figures</h2>\n" + summaryTable(frames) + "<h2>Over time</h2>\n" + plots(frames);
    if (!frames.empty() && frames.front().objects) html += methodsTable(frames);
    return measurement::htmlPage(content.title, html);
}

foundation::Outcome writeReport(const ReportContent& content, const std::vector<FrameStatistics>& frames,
                                const std::filesystem::path& file)
{
    return foundation::writeWholeFile(file, reportHtml(content, frames));
}

} // namespace trainer
