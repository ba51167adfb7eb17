// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/entities/EntityModel.h"
#include "scenery/models/entities/Person.h"
#include "scenery/models/entities/RollingParts.h"

/// What bicycles, motorbikes and wheelchairs share.
namespace scenery::models
{

inline constexpr glm::vec3 kBareMetal(0.62F, 0.63F, 0.65F), kBlackPaint(0.12F, 0.12F, 0.13F);
inline constexpr double kRiderLeanRad = 0.42; ///< of the trunk, forwards

inline glm::vec3 tintOf(const EntityShape& shape)
{
    return {shape.red, shape.green, shape.blue};
}

/// A wheel about its hub: a tyre, a rim and spokes.
Model makeSpokedWheel(double radiusM, double tyreM, int spokes);

/// The axles of a two-wheeler of this shape: the wheels stand within its length.
struct TwoWheels
{
    explicit TwoWheels(const EntityShape& shape, double radiusM)
        : radius(radiusM),
          rearX(shape.axles.empty() ? shape.backXM() + radiusM : shape.axles.back().xM),
          frontX(std::min(shape.axles.size() > 1 ? shape.axles.front().xM : 1e9, shape.frontXM() - radiusM))
    {
    }
    double radius, rearX, frontX;
};

/// Adds a rider who sits at `hip` and holds `grip` (of the left hand). Arms are bent a little.
void addRider(ModelBuilder& builder, const PersonSize& size, const PersonColours& colours,
              const glm::dvec3& hip, const glm::dvec3& grip);

/// Makes a trunk that leans forward. Frame: origin between the hips.
Model makeLeaningTrunk(const PersonSize& size, const PersonColours& colours);

/// Adds to a model the wheels of a two-wheeler. The body is part 0.
RollingPose twoWheels(EntityModel& model, const TwoWheels& wheels, Model wheel);

/// Adds a head, a tail and a brake lamp.
void addLampsOfTwoWheeler(EntityModel& model, const glm::dvec3& head, const glm::dvec3& tail);

} // namespace scenery::models
