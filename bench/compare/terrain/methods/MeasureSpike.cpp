// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/MeasureSpike.h"

#include <algorithm>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

constexpr int kPartSide = 257;     // samples, one more than a power of two
constexpr int kPlacesOfParts = 32; // cells: where blocks of the square begin, blocks of the part do

/// A part of a square, and where it lies in it.
struct Part
{
    HeightField field;
    int first = 0; ///< column and row of its south-western sample
};

Part partAround(const HeightField& square, int place)
{
    if (square.columns <= kPartSide || square.rows <= kPartSide) return {square, 0};
    Part part;
    part.first = std::clamp((place - kPartSide / 2) / kPlacesOfParts * kPlacesOfParts, 0,
                            std::min(square.columns, square.rows) - kPartSide);
    part.field.name = square.name;
    part.field.columns = part.field.rows = kPartSide;
    part.field.spacingEastM = square.spacingEastM;
    part.field.spacingNorthM = square.spacingNorthM;
    for (int row = 0; row < kPartSide; ++row)
        for (int column = 0; column < kPartSide; ++column)
            part.field.heightsM.push_back(square.heightM(part.first + column, part.first + row));
    return part;
}

/// The same view in a frame whose origin lies elsewhere: `shift` is where the old one lies in it.
viewlod::ViewState moved(viewlod::ViewState view, const glm::dvec3& shift)
{
    view.eyeWorld += shift;
    view.clipFromWorld = glm::translate(view.clipFromWorld, -shift);
    view.frustum = viewlod::Frustum(view.clipFromWorld);
    return view;
}

double trianglesOf(const Rival& rival, double tolerancePx, const viewlod::ViewState& view)
{
    const auto mesh = rival.newMesh();
    mesh->refine(view, {.errorTolerancePx = tolerancePx});
    return static_cast<double>(mesh->drawn().triangles.size());
}

} // namespace

foundation::Outcome measureSpike(const HeightField& square, const PlacedTile& tile,
                                 const ComparedFlight& flight, std::vector<MethodFigures>& methods)
{
    const int place = 4 * square.columns / 5 | 1;
    const Part part = partAround(square, place);
    const int inPart = place - part.first;
    HeightField raised = part.field;
    raised.heightsM[static_cast<std::size_t>(inPart) * static_cast<std::size_t>(raised.columns) +
                    static_cast<std::size_t>(inPart)] += static_cast<float>(2.0 * square.spacingEastM);
    const auto plain = prepareRivals(part.field), spiked = prepareRivals(raised);
    if (!plain) return plain.error();
    if (!spiked) return spiked.error();
    const int step = tile.grid().cellSide();
    for (std::size_t i = 0; i < plain->all.size(); ++i)
    {
        const auto triangles = [&](const Rivals& rivals)
        {
            const glm::dvec3 shift =
                rivals.tile->tile.position(0, 0) - tile.position(part.first * step, part.first * step);
            return trianglesOf(rivals.all[i], methods[i].tolerancePx, moved(flight.views.front(), shift));
        };
        methods[i].spikeTriangles = triangles(*spiked) - triangles(*plain);
    }
    return foundation::success();
}

} // namespace terraintool
