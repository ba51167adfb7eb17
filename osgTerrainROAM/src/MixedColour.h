// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Vec3f>

namespace osgTerrainROAM
{

/// Interpolates between two colours: a at t = 0, b at t = 1.
inline osg::Vec3f mixed(const osg::Vec3f& a, const osg::Vec3f& b, float t)
{
    return a * (1.0f - t) + b * t;
}

} // namespace osgTerrainROAM
