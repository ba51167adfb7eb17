// SPDX-License-Identifier: Apache-2.0
#include "SplineInTension.h"

#include <algorithm>
#include <cmath>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kTensionSamples = 12.0; ///< beyond this distance, tension outweighs bending
constexpr double kRelaxation = 1.5;      ///< over-relaxation: > 1 converges faster, < 2 converges
constexpr double kSettledM = 0.005;      ///< the last sweep changes less
constexpr int kMaxSweeps = 200;          ///< enough, because the coarser level gives the initial values

/// Collects the terms w·(a·z + rest)² of the energy that contain one height z; z = value() minimises them.
class EnergyAt
{
public:
    void add(double weight, double factor, double rest)
    {
        _numerator -= weight * factor * rest;
        _denominator += weight * factor * factor;
    }
    double value(double otherwise) const
    {
        return _denominator > 0.0 ? _numerator / _denominator : otherwise;
    }

private:
    double _numerator = 0.0;
    double _denominator = 0.0;
};

/// The height at (c, r) that minimises the energy near the grid's edge. Terms that reach beyond are left out:
/// the spline's natural boundary condition.
double minimiserAtEdge(const VoidLevel& level, int c, int r, double stretch)
{
    EnergyAt energy;
    const auto z = [&](int column, int row)
    { return static_cast<double>(level.heightsM[level.index(column, row)]); };
    for (int axis = 0; axis < 2; ++axis)
    {
        const int dc = 1 - axis, dr = axis;
        const auto along = [&](int k) { return z(c + k * dc, r + k * dr); };
        const auto inside = [&](int k) { return level.contains(c + k * dc, r + k * dr); };
        if (inside(-1) && inside(1)) energy.add(1.0, -2.0, along(-1) + along(1));
        if (inside(-2)) energy.add(1.0, 1.0, along(-2) - 2.0 * along(-1));
        if (inside(2)) energy.add(1.0, 1.0, along(2) - 2.0 * along(1));
        for (const int k : {-1, 1})
            if (inside(k)) energy.add(stretch, 1.0, -along(k));
    }
    for (const int dc : {-1, 1})
        for (const int dr : {-1, 1})
            if (level.contains(c + dc, r + dr))
                energy.add(2.0, 1.0, z(c + dc, r + dr) - z(c + dc, r) - z(c, r + dr));
    return energy.value(z(c, r));
}

/// The same in the interior, where all terms exist.
double minimiserInside(const VoidLevel& level, int c, int r, double stretch)
{
    const float* z = &level.heightsM[level.index(c, r)];
    const auto s = static_cast<std::ptrdiff_t>(level.columns);
    const double near = static_cast<double>(z[-1]) + z[1] + z[-s] + z[s];
    const double diagonal = static_cast<double>(z[-s - 1]) + z[-s + 1] + z[s - 1] + z[s + 1];
    const double far = static_cast<double>(z[-2]) + z[2] + z[-2 * s] + z[2 * s];
    return ((8.0 + stretch) * near - 2.0 * diagonal - far) / (20.0 + 4.0 * stretch);
}

} // namespace

void relaxSpline(VoidLevel& level)
{
    const double cellsPerTension = level.samplesPerCell / kTensionSamples;
    const double stretch = cellsPerTension * cellsPerTension;
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep)
    {
        double worst = 0.0;
        for (const VoidCell& cell : level.voids)
        {
            const bool inside = cell.column >= 2 && cell.column < level.columns - 2 && cell.row >= 2 &&
                                cell.row < level.rows - 2;
            const double target = inside ? minimiserInside(level, cell.column, cell.row, stretch)
                                         : minimiserAtEdge(level, cell.column, cell.row, stretch);
            float& height = level.heightsM[level.index(cell.column, cell.row)];
            const double former = height;
            height = std::clamp(static_cast<float>(former + kRelaxation * (target - former)), cell.lowM,
                                cell.highM);
            worst = std::max(worst, std::abs(height - former));
        }
        if (worst < kSettledM) break;
    }
}

} // namespace osgTerrainROAM::core
