// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/state/GroundProvider.h"
#include "simulation/vehicle/Ground.h"

namespace simulation
{

/// The ground of a scene (terrain, roads) as vehicles ask for it: heights of a provider, normals from its
/// heights half a metre around, one kind for all. A point whose neighbours lie outside the data is unknown.
/// Cost: five look-ups a point; one where normals are not needed.
class ProvidedGround : public Ground
{
public:
    /// `provider` may be empty: a scene without ground.
    explicit ProvidedGround(GroundProvider provider, GroundKind kind = GroundKind::grass)
        : _provider(std::move(provider)), _kind(kind)
    {
    }

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override;
    void heightsBelow(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override;

private:
    GroundPoint at(const glm::dvec3& point) const;

    GroundProvider _provider;
    GroundKind _kind;
};

} // namespace simulation
