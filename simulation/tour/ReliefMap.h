// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// A coarse look at a terrain: where it is high and rugged. At most 160 cells along the longer side.
/// Heights are freed of the Earth's curvature, so that the far corner of a large tile does not count as low.
/// `interest` is 0 on a plain at the lowest height, about 1 in rugged mountains, up to 2 on a summit that stands alone.
class ReliefMap
{
public:
    explicit ReliefMap(const TourTerrain& terrain);

    /// False when any sampled height is infinite or not a number.
    bool isFinite() const { return _isFinite; }

    int columns() const { return _columns; }
    int rows() const { return _rows; }
    glm::dvec2 centre(int column, int row) const;

    /// Of the cell at a place; 0 beyond the extent.
    double interestAt(double eastM, double northM) const;
    bool contains(double eastM, double northM) const;
    double interest(int column, int row) const { return _interest[index(column, row)]; }

    /// How far the cell stands above the land around it (a square of a fifth of the extent), in shares of the relief:
    /// what makes a mountain a landmark.
    double prominence(int column, int row) const { return _prominence[index(column, row)]; }

    /// Height between the lowest and the highest twentieth of the cells.
    double reliefM() const { return _reliefM; }

private:
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(_columns) +
               static_cast<std::size_t>(column);
    }
    void sampleHeights(const TourTerrain& terrain);
    void rateRuggedness();
    void rateProminence();
    void blur();

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
};

} // namespace simulation
