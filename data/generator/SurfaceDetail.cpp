// SPDX-License-Identifier: Apache-2.0
#include "SurfaceDetail.h"

#include <cmath>

#include "Raster.h"

namespace islandgen
{

namespace
{

constexpr float kWavelengthM = 190.0f;
constexpr float kAmplitudeM = 9.0f;

float slopeAt(const Grid<float>& heightM, int column, int row, float cellM)
{
    const float dx = heightM.clamped(column + 1, row) - heightM.clamped(column - 1, row);
    const float dy = heightM.clamped(column, row + 1) - heightM.clamped(column, row - 1);
    return std::sqrt(dx * dx + dy * dy) / (2.0f * cellM);
}

} // namespace

void roughenSlopes(Grid<float>& heightM, float cellM, Noise noise)
{
    Grid<float> amplitudeM(heightM.side);
    for (int row = 0; row < heightM.side; ++row)
    {
        for (int column = 0; column < heightM.side; ++column)
        {
            const float steep = std::clamp((slopeAt(heightM, column, row, cellM) - 0.2f) / 0.8f, 0.0f, 1.0f);
            amplitudeM.at(column, row) = kAmplitudeM * steep * steep * (3.0f - 2.0f * steep);
        }
    }
    amplitudeM = blurred(amplitudeM, std::max(1, static_cast<int>(40.0f / cellM)));
    for (int row = 0; row < heightM.side; ++row)
    {
        for (int column = 0; column < heightM.side; ++column)
        {
            const float amplitude = amplitudeM.at(column, row);
            if (heightM.at(column, row) <= 0.0f || amplitude < 0.05f) continue;
            const float u = static_cast<float>(column) * cellM / kWavelengthM;
            const float v = static_cast<float>(row) * cellM / kWavelengthM;
            heightM.at(column, row) += amplitude * (noise.ridged(u, v, 4, 0.55f) - 0.6f);
            heightM.at(column, row) = std::max(heightM.at(column, row), 0.3f);
        }
    }
}

} // namespace islandgen
