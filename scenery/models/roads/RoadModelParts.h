// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/mesh/Box.h"
#include "scenery/models/mesh/ModelBuilder.h"
#include "scenery/models/mesh/Tube.h"
#include "scenery/models/roads/RoadModel.h"

/// What the generators of road furniture share.
namespace scenery::models
{

inline constexpr glm::vec3 kZinc(0.58F, 0.60F, 0.61F);
inline constexpr double kPostRadiusM = 0.038; ///< of a tube of 76 mm

inline double orElse(double value, double otherwise)
{
    return value > 0.0 ? value : otherwise;
}

inline glm::vec2 plainUv()
{
    const SignCell cell = cellOf(SignFace::plain);
    return 0.5F * (cell.low + cell.high);
}

/// Adds a round bar of the plain cell.
inline void bar(ModelBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double radiusM)
{
    addBar(builder, from, to, radiusM, 8, plainUv());
}

/// Adds a box of the plain cell.
inline void box(ModelBuilder& builder, const glm::dvec3& low, const glm::dvec3& high)
{
    addBox(builder, {low, high, plainUv(), plainUv(), 0.7F});
}

/// Generators of what a post carries, with the post (SignHeads.cpp).
void addSign(ModelBuilder& builder, const RoadModel& model);
void addBoard(ModelBuilder& builder, const RoadModel& model);
void addLights(ModelBuilder& builder, const RoadModel& model);

/// Generators of what stands on its own (StreetFurniture.cpp).
void addDelineator(ModelBuilder& builder, const RoadModel& model);
void addLampPost(ModelBuilder& builder, const RoadModel& model);
void addCone(ModelBuilder& builder, const RoadModel& model);
void addBollard(ModelBuilder& builder, const RoadModel& model);
void addRailPost(ModelBuilder& builder, const RoadModel& model);
void addGantry(ModelBuilder& builder, const RoadModel& model);

/// The sign beside a holding position (RunwaySign.cpp).
void addRunwaySign(ModelBuilder& builder, const RoadModel& model);

} // namespace scenery::models
