// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <foundation/Earth.h>

#include "simulation/vehicle/ProvidedGround.h"

namespace trainer
{

/// z of the sea at a place, from its z at the scene's origin: it bends with the Earth.
inline double seaHeightAt(double seaLevelM, const glm::dvec3& place)
{
    return seaLevelM - (place.x * place.x + place.y * place.y) / (2.0 * foundation::kEarthRadiusM);
}

/// The ground of a scene as vehicles meet it: land by its heights; below the sea's level there is water at
/// that level.
class SceneGround final : public simulation::Ground
{
public:
    /// `seaLevelM`: z of the sea at the scene's origin, from where it bends with the Earth; absent: no sea.
    SceneGround(simulation::GroundProvider provider, std::optional<double> seaLevelM)
        : _land(std::move(provider)), _seaLevelM(seaLevelM)
    {
    }

    void below(std::span<const glm::dvec3> points, std::span<simulation::GroundPoint> answers) const override
    {
        _land.below(points, answers);
        if (!_seaLevelM) return;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double seaM = seaHeightAt(*_seaLevelM, points[i]);
            if (answers[i].isKnown && answers[i].heightM < seaM)
                answers[i] = {seaM, {0.0, 0.0, 1.0},          simulation::GroundKind::water, true,
                              1.0,  seaM - answers[i].heightM};
        }
    }

private:
    simulation::ProvidedGround _land;
    std::optional<double> _seaLevelM;
};

} // namespace trainer
