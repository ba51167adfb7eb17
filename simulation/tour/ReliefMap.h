// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// A coarse map of a terrain that tells where it is high and rugged, with at most 160 cells along the longer
/// side. The curvature of the Earth is subtracted, so that the far corner of a large tile does not count as
/// low. `interest` is 0 on a plain at the lowest height, about 1 in rugged mountains, up to 2 on an isolated
/// summit.
class ReliefMap
{
public:
    explicit ReliefMap(const TourTerrain& terrain);

    /// Returns false when a sampled height is not finite.
    bool isFinite() const { return _isFinite; }

    int columns() const { return _columns; }
    int rows() const { return _rows; }
    glm::dvec2 centre(int column, int row) const;

    /// Returns the interest of the cell at a point; 0 outside the extent. Ground that was not measured has
    /// none.
    double interestAt(double eastM, double northM) const;

    /// Returns the share of the cell at a point that was measured, 0…1; 0 outside the extent.
    double measuredAt(double eastM, double northM) const;
    bool contains(double eastM, double northM) const;
    double interest(int column, int row) const { return _interest[index(column, row)]; }

    /// Returns the height of the cell above the land around it (a square of a fifth of the extent) as a share
    /// of the relief. It is large for a landmark.
    double prominence(int column, int row) const { return _prominence[index(column, row)]; }

    /// The difference of the 5th and the 95th percentile of the heights of the cells.
    double reliefM() const { return _reliefM; }

private:
    std::size_t indexAt(double eastM, double northM) const;
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(_columns) +
               static_cast<std::size_t>(column);
    }
    void sampleHeights(const TourTerrain& terrain);
    void rateRuggedness();
    void rateProminence();
    void blur();
    void dropFilled();

    double _westM, _southM, _eastM, _northM;
    double _cellM;
    int _columns = 0;
    int _rows = 0;
    double _reliefM = 0.0;
    bool _isFinite = true;
    std::vector<double> _heights; ///< highest sample of the cell
    std::vector<double> _lows;    ///< lowest
    std::vector<double> _prominence;
    std::vector<double> _interest;
    std::vector<double> _measured; ///< share of each cell
};

} // namespace simulation
