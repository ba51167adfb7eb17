// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <string>

#include <foundation/SettingsCheck.h>

#include <osgPMObjects/core/bake/AtlasMesh.h>

#include <osgPMObjects/BakeModel>

#include "../import/StateTable.h"
#include "BakedState.h"
#include "SurfaceColours.h"

namespace osgPMObjects
{

namespace
{

using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double percent(std::size_t part, std::size_t whole)
{
    return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

/// Gives the materials of the mesh baked states; materials that are drawn alike become one.
void bakeStates(ImportedModel& model, const SurfaceColours& colours, const ImportedModel& full,
                const BakedLook& look)
{
    StateTable table;
    std::vector<core::Material> materials;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t m = 0; m < model.mesh.materials.size(); ++m)
    {
        const core::Material& old = model.mesh.materials[m];
        const osg::ref_ptr<osg::StateSet> state =
            look.stateFor(*full.states[old.state], colours.finish(m), old.has(core::Material::normal));
        const core::Material baked = table.materialOf(state, old.attributes);
        const auto known = std::find(materials.begin(), materials.end(), baked);
        numbers.push_back(static_cast<std::uint32_t>(known - materials.begin()));
        if (known == materials.end()) materials.push_back(baked);
    }
    for (core::Face& face : model.mesh.faces)
        face.material = numbers[face.material];
    model.mesh.materials = std::move(materials);
    model.states = table.states();
}

} // namespace

foundation::Outcome checkSettings(const BakeModelSettings& settings)
{
    const double slantDeg = settings.charts.mostSlantDeg;
    return foundation::SettingsCheck("BakeModelSettings")
        .require(slantDeg >= 0.0 && slantDeg < 90.0, "charts.mostSlantDeg", "is " + std::to_string(slantDeg),
                 "give degrees from 0 to below 90")
        .within("maps.samplesPerSide", settings.maps.samplesPerSide, 1.0, 8.0)
        .within("maps.reach", settings.maps.reach, 0.0)
        .outcome();
}

foundation::Result<BakedModel> bakeModel(const ImportedModel& full, const core::Mesh& simplified,
                                         const BakeModelSettings& settings)
{
    if (const auto checked = checkSettings(settings); !checked) return checked.error();
    const Clock::time_point start = Clock::now();
    auto atlas = core::packCharts(simplified, core::makeCharts(simplified, settings.charts), settings.atlas);
    if (!atlas) return atlas.error();
    BakedModel baked;
    baked.report.chartMs = msSince(start);
    const SurfaceColours colours(full);
    const Clock::time_point chartsDone = Clock::now();
    const core::BakedMaps maps = core::bakeMaps(
        full.mesh, simplified, *atlas,
        [&](std::uint32_t face, const glm::dvec3& weights, std::uint32_t simplifiedFace)
        { return colours.at(face, weights, simplified.faces[simplifiedFace].material); },
        settings.maps);
    baked.report.mapMs = msSince(chartsDone);
    baked.model.mesh = core::atlasMesh(simplified, *atlas);
    baked.model.remainder = full.remainder;
    baked.model.report = full.report;
    bakeStates(baked.model, colours, full, BakedLook(maps, settings.atlas.gutterPx));
    BakeReport& report = baked.report;
    report.charts = atlas->charts.charts.size();
    report.texelsPerUnit = atlas->texelsPerUnit;
    report.coveredPercent = percent(maps.coveredTexels, maps.colours.size());
    report.unmatchedPercent = percent(maps.unmatchedTexels, maps.lookedUpTexels);
    report.reach = maps.reach;
    report.texturesNotRead = colours.texturesNotRead();
    return baked;
}

} // namespace osgPMObjects
