// SPDX-License-Identifier: Apache-2.0
#include "RatePlot.h"

#include <array>

#include "measurement/SvgPlot.h"

namespace objectbench
{

std::string ratePlot(const std::string& model, int lights, const nlohmann::ordered_json& rows,
                     const std::vector<Contestant>& contestants)
{
    const std::array<const char*, 4> colours{"#c0392b", "#d68910", "#1f6fb2", "#5d6d7e"};
    measurement::Plot plot{
        model + ", " + std::to_string(lights) + " lights: frames per second", "faces", {}, {}};
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        plot.x.push_back((*row)["faces"].get<double>());
    for (std::size_t i = 0; i < contestants.size(); ++i)
    {
        measurement::PlotSeries series{contestants[i].name, colours[i % colours.size()], {}};
        for (auto row = rows.rbegin(); row != rows.rend(); ++row)
            series.values.push_back(1000.0 / (*row)[contestants[i].name]["ms"].get<double>());
        plot.series.push_back(std::move(series));
    }
    return measurement::svgPlot(plot);
}

std::string plotsFile(const std::vector<std::string>& plots)
{
    constexpr int kWidth = 720, kHeight = 220;
    const std::string height = std::to_string(kHeight * static_cast<int>(plots.size()));
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"720\" height=\"" + height +
        "\">\n<style>text { font: 11px sans-serif } .grid { stroke: #dde3e8 } polyline { stroke-width: "
        "1.4 }</style>\n<rect width=\"720\" height=\"" +
        height + "\" fill=\"white\"/>\n";
    for (std::size_t i = 0; i < plots.size(); ++i)
        svg += "<svg y=\"" + std::to_string(kHeight * static_cast<int>(i)) + "\" width=\"" +
               std::to_string(kWidth) + "\" height=\"" + std::to_string(kHeight) + "\">\n" + plots[i] +
               "</svg>\n";
    return svg + "</svg>\n";
}

} // namespace objectbench
