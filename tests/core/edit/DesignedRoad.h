// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/edit/GroundEditor.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

/// A road with designed heights at its points, and measurements of the ground after it is built.
class DesignedRoad
{
public:
    /// The ground's own heights, smoothed.
    DesignedRoad(osgTerrainROAM::core::Ribbon ribbon, const osgTerrainROAM::core::GroundEditor& editor)
        : _ribbon(std::move(ribbon)), _line(_ribbon.points)
    {
        for (std::size_t i = 0; i < _line.size(); ++i)
            _alongM.push_back(_line.alongM(i));
        _ribbon.heightsM = editor.profile(_ribbon, _alongM);
    }

    const osgTerrainROAM::core::Ribbon& ribbon() const { return _ribbon; }
    const osgTerrainROAM::core::PlanLine& line() const { return _line; }

    /// The largest difference between ground queries and its heights, every `stepM` along it and at points
    /// beside its middle.
    double worstM(const osgTerrainROAM::core::RoamTile& tile, double stepM,
                  std::span<const double> sidesM) const
    {
        double worstM = 0.0;
        for (double s = stepM; s < _line.lengthM() - stepM; s += stepM)
        {
            const glm::dvec2 ahead = glm::normalize(_line.at(s + 0.1) - _line.at(s - 0.1));
            for (const double sideM : sidesM)
            {
                const glm::dvec2 place = _line.at(s) + sideM * glm::dvec2(-ahead.y, ahead.x);
                const auto ground = osgTerrainROAM::core::groundAt(tile.tile, place.x, place.y);
                const double heightM = ground ? tile.tile.frame().heightOf(ground->position) : -1e9;
                worstM = std::max(worstM, std::abs(heightM - designedM(_line.footOf(place).alongM)));
            }
        }
        return worstM;
    }

private:
    double designedM(double atM) const
    {
        const auto next = std::upper_bound(_alongM.begin() + 1, _alongM.end() - 1, atM);
        const auto i = static_cast<std::size_t>(next - _alongM.begin());
        const double share = (atM - _alongM[i - 1]) / (_alongM[i] - _alongM[i - 1]);
        return std::lerp(_ribbon.heightsM[i - 1], _ribbon.heightsM[i], share);
    }

    osgTerrainROAM::core::Ribbon _ribbon;
    osgTerrainROAM::core::PlanLine _line;
    std::vector<double> _alongM;
};
