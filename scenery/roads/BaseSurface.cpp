// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/BaseSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "scenery/roads/HeightSpline.h"

namespace scenery
{

namespace
{

constexpr double kMostCells = 4e6;

/// Weighted sums over the lines of a table in one direction: `stride` between neighbours of a line of `count`
/// values.
void smoothLine(std::vector<float>& values, std::size_t first, std::size_t stride, int count,
                const std::vector<double>& kernel, std::vector<float>& line)
{
    const int reach = static_cast<int>(kernel.size()) - 1;
    line.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
    {
        double sum = 0.0;
        for (int k = -reach; k <= reach; ++k)
            sum += kernel[static_cast<std::size_t>(std::abs(k))] *
                   values[first + stride * static_cast<std::size_t>(std::clamp(i + k, 0, count - 1))];
        line[static_cast<std::size_t>(i)] = static_cast<float>(sum);
    }
    for (int i = 0; i < count; ++i)
        values[first + stride * static_cast<std::size_t>(i)] = line[static_cast<std::size_t>(i)];
}

void smooth(std::vector<float>& values, int columns, int rows, double sigmaCells)
{
    std::vector<double> kernel;
    double sum = 0.0;
    for (int k = 0; k <= static_cast<int>(std::ceil(3.0 * sigmaCells)); ++k)
    {
        kernel.push_back(std::exp(-0.5 * k * k / (sigmaCells * sigmaCells)));
        sum += (k == 0 ? 1.0 : 2.0) * kernel.back();
    }
    for (double& weight : kernel)
        weight /= sum;
    std::vector<float> line;
    for (int row = 0; row < rows; ++row)
        smoothLine(values, static_cast<std::size_t>(row) * columns, 1, columns, kernel, line);
    for (int column = 0; column < columns; ++column)
        smoothLine(values, static_cast<std::size_t>(column), static_cast<std::size_t>(columns), rows, kernel,
                   line);
}

} // namespace

BaseSurface::BaseSurface(const glm::dvec2& low, const glm::dvec2& high,
                         const foundation::HeightInPlan& ground)
{
    const double marginM = 4.0 * kSigmaM;
    const glm::dvec2 extentM = high - low + 2.0 * marginM;
    _cellM = std::max(kCellM, std::sqrt(extentM.x * extentM.y / kMostCells));
    _low = low - marginM;
    _columns = static_cast<int>(extentM.x / _cellM) + 4;
    _rows = static_cast<int>(extentM.y / _cellM) + 4;
    std::vector<float> known;
    for (int row = 0; row < _rows; ++row)
        for (int column = 0; column < _columns; ++column)
        {
            const auto height = ground(_low + _cellM * glm::dvec2(column, row));
            _heightsM.push_back(static_cast<float>(height.value_or(0.0)));
            known.push_back(height ? 1.0f : 0.0f);
        }
    const double sigmaCells = std::max(kSigmaM / _cellM, 0.5);
    smooth(_heightsM, _columns, _rows, sigmaCells);
    smooth(known, _columns, _rows, sigmaCells);
    float last = 0.0f; // far from all data: the height of the neighbour before
    for (std::size_t i = 0; i < _heightsM.size(); ++i)
        last = _heightsM[i] = known[i] > 1e-3f ? _heightsM[i] / known[i] : last;
}

double BaseSurface::heightM(const glm::dvec2& plan) const
{
    const glm::dvec2 place =
        glm::clamp((plan - _low) / _cellM, glm::dvec2(1.0), glm::dvec2(_columns - 2.001, _rows - 2.001));
    const int column = static_cast<int>(place.x), row = static_cast<int>(place.y);
    const auto across = splineWeights(place.x - column), along = splineWeights(place.y - row);
    double height = 0.0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            height += across[static_cast<std::size_t>(i)] * along[static_cast<std::size_t>(j)] *
                      double{_heightsM[static_cast<std::size_t>(row - 1 + j) * _columns + (column - 1 + i)]};
    return height;
}

} // namespace scenery
