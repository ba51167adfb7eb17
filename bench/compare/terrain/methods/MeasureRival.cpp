// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/MeasureRival.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <numeric>
#include <utility>

#include <foundation/Threads.h>

#include <osgPMObjects/core/order/TriangleStrips.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/PlanTriangle.h>

#include "compare/terrain/drivers/BenchParts.h"
#include "compare/terrain/drivers/FrameChange.h"
#include "compare/terrain/drivers/Measured.h"
#include "compare/terrain/methods/IncoherentFrames.h"
#include "compare/terrain/methods/LightChange.h"
#include "compare/terrain/methods/MeasureChanges.h"
#include "compare/terrain/methods/MeasureSpike.h"
#include "compare/terrain/methods/PaintMethods.h"
#include "compare/terrain/methods/TinLeavesRival.h"
#include "compare/terrain/methods/WorkFit.h"
#include "measurement/Percentile.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

double mean(const std::vector<double>& values)
{
    return values.empty()
               ? 0.0
               : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The mean number of triangles of the strips that the dual graph of a mesh makes.
double dualStripLength(const DrawnMesh& drawn)
{
    std::vector<osgPMObjects::core::Triangle> triangles;
    for (const LeafTriangle& t : drawn.triangles)
        triangles.push_back({t.vertices[0], t.vertices[1], t.vertices[2]});
    return static_cast<double>(triangles.size()) /
           static_cast<double>(
               std::max<std::size_t>(osgPMObjects::core::dualGraphStrips(triangles).size(), 1));
}

/// Measures how the last frame's triangles lie, and what they look like in plan.
void measureShape(const RivalMesh& mesh, const DrawnMesh& drawn, const viewlod::Frustum& frustum,
                  MethodFigures& figures)
{
    if (const auto order = mesh.order())
    {
        figures.transformsPerTriangle = order->missesBatch32;
        figures.stripLength = order->stripLength;
        figures.dualStripLength = dualStripLength(drawn);
    }
    const auto count = static_cast<double>(drawn.triangles.size());
    if (const auto visible = mesh.trianglesIn(frustum)) figures.visiblePercent = 100.0 * *visible / count;
    std::int64_t largest = 0, smallest = std::numeric_limits<std::int64_t>::max();
    std::size_t regular = 0;
    for (const LeafTriangle& t : drawn.triangles)
    {
        const std::array corners{drawn.grid[t.vertices[0]], drawn.grid[t.vertices[1]],
                                 drawn.grid[t.vertices[2]]};
        const std::int64_t area = PlanTriangle{corners}.doubleArea();
        largest = std::max(largest, area);
        smallest = std::min(smallest, area);
        std::array<std::int64_t, 3> sides{};
        for (std::size_t i = 0; i < 3; ++i)
        {
            const std::int64_t columns = corners[i].column - corners[(i + 1) % 3].column,
                               rows = corners[i].row - corners[(i + 1) % 3].row;
            sides[i] = columns * columns + rows * rows;
        }
        std::sort(sides.begin(), sides.end());
        regular += sides[0] == sides[1] && sides[2] == 2 * sides[0] ? 1 : 0;
    }
    figures.regularPercent = 100.0 * static_cast<double>(regular) / count;
    figures.areaRatio =
        static_cast<double>(largest) / static_cast<double>(std::max<std::int64_t>(smallest, 1));
}

/// Flies all frames at the tolerance of `figures`.
void fly(const Rival& rival, const RoamTile& tile, const ComparedFlight& flight, MethodFigures& figures)
{
    const auto mesh = rival.newMesh();
    std::vector<double> changed, lit;
    DrawnMesh before;
    for (std::size_t frame = 0; frame < flight.views.size(); ++frame)
    {
        const viewlod::ViewState& view = flight.views[frame];
        const double us =
            microsecondsOf([&] { mesh->refine(view, {.errorTolerancePx = figures.tolerancePx}); });
        DrawnMesh now = mesh->drawn();
        FrameChange change;
        LightChange light;
        DrawnMeshReport found;
        foundation::Threads looks; // joined before the next frame is timed
        if (flight.isChecked(frame)) looks.run([&] { found = checkDrawnMesh(tile, now, &view); });
        if (frame > 0) looks.run([&] { light = lightChangeBetween(before, now); });
        if (frame > 0) change = changeBetween(tile.tile, before, now, view);
        looks.join();
        figures.trueErrorPx = std::max(figures.trueErrorPx, found.maxErrorPx);
        figures.breaks += found.tJunctions + found.cracks;
        if (frame > 0)
        {
            lit.push_back(light.turnedPercent);
            figures.lightDeg = std::max(figures.lightDeg, light.largestDeg);
            const auto triangles = static_cast<double>(now.triangles.size());
            figures.frameUs.push_back(us);
            figures.frameTriangles.push_back(triangles);
            changed.push_back(100.0 * static_cast<double>(change.newTriangles) / triangles);
            figures.popPx = std::max(figures.popPx, change.popPx);
        }
        before = std::move(now);
    }
    figures.triangles = mean(figures.frameTriangles);
    figures.changedPercent = mean(changed);
    figures.lightPercent = mean(lit);
    measureShape(*mesh, before, flight.views.back().frustum, figures);
    figures.preparationS += mesh->preparationS();
    figures.memoryMB = 1e-6 * static_cast<double>(rival.sharedBytes + mesh->memoryBytes());
}

/// Flies the checked frames within a ceiling, with work for more.
CeilingFigures flyWithin(double ceiling, const Rival& rival, const RoamTile& tile,
                         const ComparedFlight& flight)
{
    constexpr double kMoreThanFits = 0.01; // of the error
    const auto mesh = rival.newMesh();
    CeilingFigures figures;
    figures.asked = std::floor(ceiling);
    figures.ceiling = std::max(figures.asked, rival.fewestTriangles);
    for (std::size_t frame = 0; frame < flight.views.size(); ++frame)
    {
        const RefineResult result =
            mesh->refine(flight.views[frame], {.errorTolerancePx = kMoreThanFits * flight.errorPx,
                                               .maxTriangles = static_cast<std::uint32_t>(figures.ceiling)});
        figures.framesAbove += result.leaves > figures.ceiling ? 1 : 0;
        figures.leastShare = std::min(figures.leastShare, result.leaves / figures.ceiling);
        if (flight.isChecked(frame))
            figures.trueErrorPx =
                std::max(figures.trueErrorPx, trueErrorPx(*mesh, tile, flight.views[frame]));
    }
    return figures;
}

/// Flies in slices too short for the work of the first frames, and checks what each leaves.
SliceFigures flyInSlices(double tolerancePx, const Rival& rival, const RoamTile& tile,
                         const ComparedFlight& flight)
{
    constexpr double kSliceUs = 20.0;
    struct Look
    {
        DrawnMesh mesh;
        bool isSound;
    };
    const auto mesh = rival.newMesh();
    SliceFigures figures;
    std::vector<Look> looked; // as many frames as are checked at once
    for (const viewlod::ViewState& view : flight.views)
    {
        const RefineResult result = mesh->refine(view, {.errorTolerancePx = tolerancePx,
                                                        .maxTimeUs = kSliceUs,
                                                        .clock = viewlod::Budget::Clock::modelled});
        figures.stops += result.sliceBound ? 1 : 0;
        looked.push_back({mesh->drawn(), mesh->isValid()});
        if (looked.size() < foundation::processors() && &view != &flight.views.back()) continue;
        foundation::Threads checks;
        for (Look& look : looked)
            checks.run(
                [&look, &tile]
                {
                    const DrawnMeshReport found = checkDrawnMesh(tile, look.mesh, nullptr);
                    look.isSound = look.isSound && found.tJunctions + found.cracks == 0;
                });
        checks.join();
        figures.faults += static_cast<std::size_t>(
            std::count_if(looked.begin(), looked.end(), [](const Look& look) { return !look.isSound; }));
        looked.clear();
    }
    return figures;
}

/// Adds rows whose preparation depends on the flight, and those of programs.
void addFurtherRivals(Rivals& rivals, const ComparedFlight& flight,
                      const std::vector<ExternalMethod>& external)
{
    constexpr double kShareOfError = 0.5; // of the compared error, where the flight is nearest to the ground
    double tinErrorM = std::numeric_limits<double>::infinity();
    for (std::size_t frame = 0; frame < flight.views.size(); ++frame)
    {
        if (!flight.isChecked(frame)) continue;
        const viewlod::ViewState& view = flight.views[frame];
        if (const auto place = sampleInSight(rivals.tile->tile, view))
            tinErrorM =
                std::min(tinErrorM, kShareOfError * flight.errorPx / view.pixelsPerTangent *
                                        glm::distance(rivals.tile->tile.position(place->column, place->row),
                                                      view.eyeWorld));
    }
    if (auto leaves = tinLeavesRival(rivals.tile, tinErrorM)) rivals.all.push_back(std::move(*leaves));
    for (const ExternalMethod& method : external)
        if (auto rival = externalRival(method, rivals.tile))
            rivals.all.push_back(std::move(*rival));
        else
            std::cerr << "compare_terrain: no row of " << method.name << ": " << rival.error().message()
                      << '\n';
}

/// Leaves out the rows of programs that have failed on the way.
void leaveOutFailed(Rivals& rivals, std::vector<MethodFigures>& methods)
{
    for (std::size_t i = methods.size(); i-- > 0;)
    {
        const auto failure = rivals.all[i].failure ? rivals.all[i].failure() : std::nullopt;
        if (!failure) continue;
        std::cerr << "compare_terrain: no row of " << methods[i].name << ": " << failure->message() << '\n';
        rivals.all.erase(rivals.all.begin() + static_cast<std::ptrdiff_t>(i));
        methods.erase(methods.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

} // namespace

MethodFigures measureRival(const Rival& rival, const RoamTile& tile, const ComparedFlight& flight)
{
    MethodFigures figures;
    figures.name = rival.name;
    figures.isOfBlocks = rival.isOfBlocks;
    figures.adapts = rival.adapts;
    figures.preparationS = rival.preparationS;
    figures.parts = static_cast<double>(rival.parts);
    figures.sideSamples = tile.tile.field().columns;
    figures.tolerancePx = toleranceForError(rival, tile, flight);
    fly(rival, tile, flight, figures);
    figures.adaptUsP50 = measurement::percentile(figures.frameUs, 0.5);
    figures.adaptUsP99 = measurement::percentile(figures.frameUs, 0.99);
    figures.adaptUsMax = measurement::percentile(figures.frameUs, 1.0);
    if (!rival.adapts) figures.frameUs.clear();
    if (rival.stopsInTime) figures.slices = flyInSlices(figures.tolerancePx, rival, tile, flight);
    figures.morph = measureMorph(rival, flight, figures.tolerancePx);
    if (rival.adapts) figures.fit = measureWork(rival, flight, figures.tolerancePx);
    return figures;
}

foundation::Result<DemComparison> compareOver(const HeightField& square, const FlightMaker& flightOver,
                                              const Painting& painting,
                                              const std::vector<ExternalMethod>& external)
{
    auto plain = prepareRivals(square);
    if (!plain) return plain.error();
    const auto flight = flightOver(plain->tile->tile);
    if (!flight) return flight.error();
    DemComparison comparison;
    comparison.dem = square.name;
    addFurtherRivals(*plain, *flight, external);
    for (const Rival& rival : plain->all)
        comparison.methods.push_back(measureRival(rival, *plain->tile, *flight));
    leaveOutFailed(*plain, comparison.methods);
    const double ceiling = comparison.of("roam")->triangles;
    for (std::size_t i = 0; i < plain->all.size(); ++i)
    {
        const Rival& rival = plain->all[i];
        MethodFigures& figures = comparison.methods[i];
        if (rival.keepsCeiling) figures.ceiling = flyWithin(ceiling, rival, *plain->tile, *flight);
    }
    if (const auto measured = measureSpike(square, plain->tile->tile, *flight, comparison.methods); !measured)
        return measured.error();
    if (painting.painter)
        if (const auto painted = paintMethods(*painting.painter, *plain, *flight, painting.folder,
                                              painting.stem, comparison.methods);
            !painted)
            return painted.error();
    const auto merges = measureMerges(plain->tile);
    comparison.merges = {merges["nsPerRemovedTriangle"], merges["singleMergeNsPerRemovedTriangle"]};
    comparison.reworks = measureReworks(plain->tile, comparison.of("roam")->tolerancePx);
    measureEdits(*plain, *flight, comparison.methods); // the tile is another one afterwards
    return comparison;
}

} // namespace terraintool
