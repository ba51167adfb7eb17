// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/drivers/BenchRun.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/LeafOrder.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

#include "compare/terrain/drivers/Measured.h"
#include "measurement/Percentile.h"

namespace terraintool
{

namespace
{

using measurement::percentile;

using namespace osgTerrainROAM::core;

/// Sums over the measured frames.
struct Totals
{
    std::vector<double> frameUs;
    double triangles = 0.0, changes = 0.0, checks = 0.0, uploadBytes = 0.0, maxErrorPx = 0.0;
};

double uploadBytes(const RoamMesh& mesh)
{
    if (const PatchPool* patches = mesh.patches())
        return static_cast<double>(patches->written().size() * patches->shape().vertices.size() *
                                   sizeof(MeshVertex));
    const MeshChanges& changes = mesh.changes();
    const auto distinct = [](const std::vector<std::uint32_t>& slots)
    { return static_cast<double>(std::unordered_set<std::uint32_t>(slots.begin(), slots.end()).size()); };
    return distinct(changes.vertices) * sizeof(MeshVertex) +
           distinct(changes.triangles) * sizeof(LeafTriangle);
}

/// What is measured: one of the drivers, or starting over.
class Subject
{
public:
    explicit Subject(const BenchRun& run) : _run(run)
    {
        if (run.driver) _mesh.emplace(run.bounds, *run.driver, run.placement);
    }

    void frame(const viewlod::ViewState& view, bool counts, Totals& totals)
    {
        RefineResult result;
        const double us = microsecondsOf(
            [&]
            {
                if (_mesh)
                    result = _mesh->refine(view, {.errorTolerancePx = _run.tolerancePx});
                else
                    refineFromScratch(_run.bounds, view, _run.tolerancePx, _leaves);
            });
        if (!counts) return;
        totals.frameUs.push_back(us);
        totals.triangles +=
            _mesh ? result.leaves
                  : std::ldexp(static_cast<double>(_leaves.size()), _run.bounds.patchExponent());
        totals.changes += 0.5 * (result.splits + result.merges);
        totals.checks += result.checks;
        if (_mesh) totals.uploadBytes += uploadBytes(*_mesh);
    }

    DrawnMesh drawn() const { return _mesh ? _mesh->drawn() : meshOfLeaves(_run.bounds, _leaves); }

    /// How the triangles lie that the last frame would draw.
    std::optional<LeafOrder> order() const { return _mesh ? std::optional(orderOf(*_mesh)) : std::nullopt; }

    double bytesPerTriangle() const
    {
        return _mesh ? std::ldexp(static_cast<double>(_mesh->memoryBytes()) / _mesh->tree().leafCount(),
                                  -_run.bounds.patchExponent())
                     : 0.0;
    }

private:
    const BenchRun& _run;
    std::optional<RoamMesh> _mesh;
    std::vector<GridTriangle> _leaves;
};

nlohmann::ordered_json rowOf(const BenchRun& run, const Totals& totals, const Subject& subject)
{
    const auto frames = static_cast<double>(totals.frameUs.size());
    const auto per = [](double sum, double count) { return count > 0.0 ? sum / count : 0.0; };
    double spentUs = 0.0;
    for (const double us : totals.frameUs)
        spentUs += us;
    nlohmann::ordered_json row;
    row["dem"] = run.dem;
    row["driver"] = run.driverName();
    row["path"] = measurement::pathName(run.path);
    row["patchExponent"] = run.bounds.patchExponent();
    row["tolerancePx"] = run.tolerancePx;
    row["centrePixels"] = run.centrePixels;
    row["triangles"] = per(totals.triangles, frames);
    row["adaptUsP50"] = percentile(totals.frameUs, 0.5);
    row["adaptUsP95"] = percentile(totals.frameUs, 0.95);
    row["adaptUsP99"] = percentile(totals.frameUs, 0.99);
    row["adaptUsMax"] = percentile(totals.frameUs, 1.0);
    row["changesPerFrame"] = per(totals.changes, frames);
    row["checksPerFrame"] = per(totals.checks, frames);
    row["nsPerChange"] = per(spentUs * 1e3, totals.changes);
    row["nsPerTriangle"] = per(spentUs * 1e3, totals.triangles);
    row["maxErrorPx"] = totals.maxErrorPx;
    row["uploadBytesPerChange"] = per(totals.uploadBytes, // a diamond: four leaves came, two went, or back
                                      std::ldexp(6.0 * totals.changes, run.bounds.patchExponent()));
    if (run.driver) row["bytesPerActiveTriangle"] = subject.bytesPerTriangle();
    if (const auto order = subject.order())
    {
        row["stripLength"] = order->stripLength;
        row["stripVerticesPerTriangle"] = order->stripVertices;
        row["transformsPerTriangleFifo16"] = order->missesFifo16;
        row["transformsPerTriangleFifo32"] = order->missesFifo32;
        row["transformsPerTriangleBatch32"] = order->missesBatch32;
        row["gapsPerTriangle"] = order->gaps;
    }
    return row;
}

} // namespace

std::string BenchRun::driverName() const
{
    return driver ? std::string(osgTerrainROAM::core::driverName(*driver)) : "scratch";
}

viewlod::ViewState BenchRun::view(int frame) const
{
    viewlod::ViewState view = measurement::BenchmarkFlight::along(path).view(bounds.tile().tile, frame);
    if (centrePixels) view.cornerStretch = 1.0;
    return view;
}

foundation::Result<nlohmann::ordered_json> measure(const BenchRun& run, const FrameSink& sink)
{
    Subject subject(run);
    Totals totals;
    for (int frame = 0; frame < run.frames; ++frame)
    {
        const viewlod::ViewState view = run.view(frame);
        subject.frame(view, frame > 0 || run.frames == 1, totals);
        if ((frame + 1) % run.framesBetweenChecks != 0 && frame != run.frames - 1) continue;
        const DrawnMesh drawn = subject.drawn();
        totals.maxErrorPx =
            std::max(totals.maxErrorPx, checkDrawnMesh(run.bounds.tile(), drawn, &view).maxErrorPx);
        if (!sink) continue;
        if (const auto taken = sink(frame, view, drawn); !taken) return taken.error();
    }
    return rowOf(run, totals, subject);
}

} // namespace terraintool
