// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/PaintMethods.h"

#include <algorithm>

namespace terraintool
{

namespace
{

constexpr std::size_t kMeasuredPictures = 12;
constexpr double kCoarser = 4.0;

/// Frames at equal distances along the flight.
std::vector<viewlod::ViewState> someViews(const ComparedFlight& flight)
{
    const std::size_t count = std::min(flight.views.size(), kMeasuredPictures);
    std::vector<viewlod::ViewState> views;
    for (std::size_t i = 0; i < count; ++i)
        views.push_back(flight.views[i * flight.views.size() / count]);
    return views;
}

} // namespace

foundation::Outcome paintMethods(MeshPainter& painter, const Rivals& rivals, const ComparedFlight& flight,
                                 const std::filesystem::path& folder, const std::string& stem,
                                 std::vector<MethodFigures>& methods)
{
    const std::vector<viewlod::ViewState> views = someViews(flight);
    const viewlod::ViewState& middle = flight.views[flight.views.size() / 2];
    for (std::size_t i = 0; i < rivals.all.size(); ++i)
    {
        const Rival& rival = rivals.all[i];
        MethodFigures& figures = methods[i];
        if (rival.drawnBy && views.size() > 2)
        {
            const auto ms =
                painter.pictureMs({rivals.tile, *rival.drawnBy, rival.prepared}, figures.tolerancePx, views);
            if (!ms) return ms.error();
            figures.frameMs = *ms;
        }
        if (folder.empty()) continue;
        const auto mesh = rival.newMesh();
        mesh->refine(middle, {.errorTolerancePx = kCoarser * figures.tolerancePx});
        figures.picture = stem + "-" + figures.name + ".jpg";
        if (const auto done = painter.write(mesh->drawn(), middle, folder / figures.picture); !done)
            return done.error();
    }
    return foundation::success();
}

} // namespace terraintool
