// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <foundation/Threads.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>

#include "compare/terrain/methods/MeasureRival.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

/// The largest true error in the checked frames, each thread with a mesh of its own: without morphing a mesh
/// depends on the eye alone.
double errorAt(double tolerancePx, const Rival& rival, const RoamTile& tile, const ComparedFlight& flight)
{
    std::vector<const viewlod::ViewState*> views;
    for (std::size_t frame = 0; frame < flight.views.size(); ++frame)
        if (flight.isChecked(frame)) views.push_back(&flight.views[frame]);
    std::vector<double> errorsPx(views.size());
    const std::size_t threads = std::min(foundation::processors(), views.size());
    foundation::Threads shares;
    for (std::size_t share = 0; share < threads; ++share)
        shares.run(
            [&, share]
            {
                const auto mesh = rival.newMesh();
                for (std::size_t i = share; i < views.size(); i += threads)
                {
                    mesh->refine(*views[i], {.errorTolerancePx = tolerancePx});
                    errorsPx[i] = trueErrorPx(*mesh, tile, *views[i]);
                }
            });
    shares.join();
    return *std::max_element(errorsPx.begin(), errorsPx.end());
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

/// A tolerance, and the true error that it led to.
struct Tried
{
    double tolerancePx, errorPx;
};

} // namespace

double trueErrorPx(const RivalMesh& mesh, const RoamTile& tile, const viewlod::ViewState& view)
{
    return drawnErrorPx(tile, mesh.drawn(), view);
}

double toleranceForError(const Rival& rival, const RoamTile& tile, const ComparedFlight& flight)
{
    constexpr int kMostTries = 20;
    constexpr double kMostFactor = 8.0; // of a step into the unknown
    // The error jumps between tolerances so near to each other. One mesh for all eyes is made and measured
    // whole for each.
    const double narrow = rival.adapts ? 1.0005 : 1.01;
    constexpr double kAtEnds = 0.05;     // of the interval: nearer to an end than this it hardly shrinks
    constexpr double kLargestPx = 512.0; // times the error: nothing happens beyond
    Nearest nearest(flight.errorPx);
    std::optional<Tried> low, high; // without and with an error beyond what is wanted
    double tolerancePx = flight.errorPx;
    for (int i = 0; i < kMostTries && !nearest.isFound(); ++i)
    {
        const double errorPx = errorAt(tolerancePx, rival, tile, flight);
        (nearest.isBeyond(tolerancePx, errorPx) ? high : low) = Tried{tolerancePx, errorPx};
        if (low && high && high->tolerancePx < narrow * low->tolerancePx) break;
        if (!high && low->tolerancePx > kLargestPx * flight.errorPx) break;
        if (!low || !high)
        {
            const double factor = errorPx > 0.0 ? flight.errorPx / errorPx : kMostFactor;
            tolerancePx *=
                high ? std::clamp(factor, 1.0 / kMostFactor, 0.9) : std::clamp(factor, 1.1, kMostFactor);
            continue;
        }
        const double from = std::log(low->tolerancePx), width = std::log(high->tolerancePx) - from;
        const double rise = low->errorPx > 0.0 ? std::log(high->errorPx / low->errorPx) : 0.0;
        double share = rise > 0.0 ? std::log(flight.errorPx / low->errorPx) / rise : 0.5;
        if (i % 3 == 2 || !(share > kAtEnds && share < 1.0 - kAtEnds)) share = 0.5;
        tolerancePx = std::exp(from + share * width);
    }
    return nearest.tolerancePx() > 0.0 ? nearest.tolerancePx()
                                       : low.value_or(Tried{tolerancePx, 0.0}).tolerancePx;
}

} // namespace terraintool
