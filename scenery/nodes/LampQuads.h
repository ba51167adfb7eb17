// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <osg/Geometry>

#include "scenery/models/entities/EntityModel.h"

namespace scenery
{

/// The corners of a lamp's rectangle: across and up, half its sides.
inline constexpr std::array<std::array<float, 2>, 4> kLampCorners{
    {{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}};

struct LampCorner
{
    osg::Vec3f place, normal; ///< in the frame of the entity, metres
};

using LampCornerOf = std::function<LampCorner(const models::EntityLamp& lamp, float across, float up)>;

/// Returns a geometry with a rectangle of two triangles for each lamp, four vertices after the other in the
/// order of kLampCorners. `colours`: one for each vertex, which may change later; 0 where they are new.
osg::ref_ptr<osg::Geometry> makeLampQuads(const std::vector<models::EntityLamp>& lamps,
                                          osg::Vec4Array& colours, const LampCornerOf& cornerOf);

} // namespace scenery
