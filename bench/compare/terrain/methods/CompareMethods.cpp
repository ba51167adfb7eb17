// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iomanip>
#include <iostream>

#include <foundation/WholeFile.h>

#include "compare/terrain/methods/CompareHtml.h"
#include "compare/terrain/methods/CompareJson.h"
#include "compare/terrain/methods/CompareMarkdown.h"
#include "compare/terrain/methods/MeasureRival.h"
#include "compare/terrain/methods/MethodsRequest.h"
#include "compare/terrain/methods/Verdicts.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "simulation/parser/ParseScenario.h"
#include "terraintool/FlightViews.h"

namespace terraintool
{

namespace
{

using osgTerrainROAM::core::PlacedTile;
using Views = std::vector<viewlod::ViewState>;

foundation::Result<Views> viewsOver(const PlacedTile& tile, const MethodsRequest& request)
{
    if (!request.flight.empty())
    {
        auto parsed = simulation::readScenario(request.flight);
        if (!parsed) return parsed.error();
        return scenarioViews(std::move(parsed->scenario), request.flight.string(), tile, request.frames);
    }
    const auto flight = measurement::BenchmarkFlight::along(measurement::Path::flight);
    Views views;
    for (int frame = 0; frame < request.frames; ++frame)
        views.push_back(flight.view(tile, frame));
    return views;
}

foundation::Result<ComparedFlight> flightOver(const PlacedTile& tile, const MethodsRequest& request)
{
    auto views = viewsOver(tile, request);
    if (!views) return views.error();
    if (views->size() < 2)
        return foundation::Error{request.flight.string(), "the flight has fewer than two frames",
                                 "let it last longer"};
    return ComparedFlight{std::move(*views), request.errorPx, request.framesBetweenChecks};
}

/// The folder beside the report that its pictures go to, made; empty: no report.
foundation::Result<std::filesystem::path> pictureFolder(const MethodsRequest& request)
{
    if (request.html.empty()) return std::filesystem::path();
    const std::filesystem::path folder = request.html.parent_path() / picturesOf(request.html);
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) return foundation::Error{folder.string(), failed.message(), "name a folder that can be made"};
    return folder;
}

std::vector<ExternalMethod> externalMethods(const MethodsRequest& request)
{
    std::vector<ExternalMethod> methods;
    for (const std::string& text : request.external)
    {
        const std::size_t at = text.find('=');
        methods.push_back({text.substr(0, at), text.substr(at + 1)});
    }
    return methods;
}

void print(const DemComparison& dem)
{
    std::cout << dem.dem << '\n' << std::fixed;
    for (const MethodFigures& m : dem.methods)
    {
        std::cout << "  " << std::left << std::setw(20) << m.name << std::right << std::setprecision(0)
                  << std::setw(9) << m.triangles << " triangles" << std::setprecision(2) << std::setw(7)
                  << m.trueErrorPx << " px off";
        if (m.adapts)
            std::cout << std::setprecision(1) << std::setw(9) << m.adaptUsP50 << " us" << std::setw(9)
                      << m.adaptUsP99 << " us p99" << std::setprecision(2) << std::setw(7) << m.changedPercent
                      << " % change" << std::endl;
        else
            std::cout << "   one mesh for all eyes" << std::endl;
    }
    for (const RequirementVerdict& v : requirementVerdicts(dem))
        std::cout << "  " << v.requirement << ' ' << v.method << ": " << v.verdict << ", " << v.figure
                  << '\n';
}

} // namespace

foundation::Result<terminal::Report> compareMethods(const MethodsRequest& request)
{
    for (const std::filesystem::path& file : {request.html, request.markdown})
        if (const auto writable = foundation::checkWritable(file); !writable) return writable.error();
    const auto painter = makePainter();
    if (!painter) std::cerr << "compare_terrain: no pictures: " << painter.error().message() << '\n';
    const auto folder = pictureFolder(request);
    if (!folder) return folder.error();
    std::vector<DemComparison> dems;
    for (const std::string& file : request.files)
    {
        const auto field = osgTerrainROAM::core::importDem(file, request.import);
        if (!field) return field.error();
        const auto square = squareOf(*field, request.square, file);
        if (!square) return square.error();
        const Painting painting{painter ? painter->get() : nullptr, *folder,
                                std::filesystem::path(file).stem().string()};
        auto compared = compareOver(
            *square, [&](const PlacedTile& tile) { return flightOver(tile, request); }, painting,
            externalMethods(request));
        if (!compared) return compared.error();
        compared->dem = std::filesystem::path(file).filename().string();
        print(*compared);
        dems.push_back(std::move(*compared));
    }
    for (const ClaimVerdict& v : claimVerdicts(dems))
        std::cout << v.claim << ": " << v.verdict << ", " << v.figure << '\n';
    if (!request.html.empty())
        if (const auto written =
                foundation::writeWholeFile(request.html, comparisonHtml(dems, picturesOf(request.html)));
            !written)
            return written.error();
    if (!request.markdown.empty())
        if (const auto written = foundation::writeWholeFile(request.markdown, comparisonMarkdown(dems));
            !written)
            return written.error();
    return terminal::Report{comparisonJson(dems), true};
}

} // namespace terraintool
