// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>

#include "terraintool/compare/MeasureRival.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

/// The largest true error of a new mesh in the checked frames.
double errorAt(double tolerancePx, const Rival& rival, const RoamTile& tile, const ComparedFlight& flight)
{
    const auto mesh = rival.newMesh();
    double largestPx = 0.0;
    for (std::size_t frame = 0; frame < flight.views.size(); ++frame)
    {
        if (!flight.isChecked(frame)) continue;
        mesh->refine(flight.views[frame], {.errorTolerancePx = tolerancePx});
        largestPx = std::max(largestPx, trueErrorPx(*mesh, tile, flight.views[frame]));
    }
    return largestPx;
}

/// Remembers the tolerance whose error is nearest to the wanted one, by ratio.
class Nearest
{
public:
    explicit Nearest(double wantedPx) : _wantedPx(wantedPx) {}

    /// Returns whether the error is beyond the wanted one.
    bool isBeyond(double tolerancePx, double errorPx)
    {
        const double off = errorPx > 0.0 ? std::abs(std::log(errorPx / _wantedPx)) : _off;
        if (off < _off || (off == _off && tolerancePx > _tolerancePx)) // fewer triangles for the same error
        {
            _off = off;
            _tolerancePx = tolerancePx;
        }
        return errorPx > _wantedPx;
    }
    bool isFound() const { return _off < kEnough; }
    double tolerancePx() const { return _tolerancePx; }

private:
    static constexpr double kEnough = 0.01; ///< one per cent
    double _wantedPx;
    double _off = 1e300;
    double _tolerancePx = 0.0;
};

} // namespace

double trueErrorPx(const RivalMesh& mesh, const RoamTile& tile, const viewlod::ViewState& view)
{
    return checkDrawnMesh(tile, mesh.drawn(), &view).maxErrorPx;
}

double toleranceForError(const Rival& rival, const RoamTile& tile, const ComparedFlight& flight)
{
    constexpr int kDoublings = 8, kHalvings = 12;
    Nearest nearest(flight.errorPx);
    const auto isBeyond = [&](double tolerancePx)
    { return nearest.isBeyond(tolerancePx, errorAt(tolerancePx, rival, tile, flight)); };
    double low = flight.errorPx, high = flight.errorPx;
    for (int i = 0; i < kDoublings && isBeyond(low); ++i)
        low *= 0.5;
    for (int i = 0; i < kDoublings && !isBeyond(high); ++i)
        high *= 2.0;
    for (int i = 0; i < kHalvings && !nearest.isFound(); ++i)
    {
        const double middle = std::sqrt(low * high);
        (isBeyond(middle) ? high : low) = middle;
    }
    return nearest.tolerancePx() > 0.0 ? nearest.tolerancePx() : low;
}

} // namespace terraintool
