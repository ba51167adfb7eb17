// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec4.hpp>

#include <osg/Array>

namespace osgPMObjects
{

/// Returns the values of an array of any element type as the graphics card reads them: missing components are
/// (0, 0, 0, 1), integers are scaled to 0…1 or -1…1 if `isNormalised`. Matrices and 64-bit integers, which no
/// attribute of fixed function has, give no values.
std::vector<glm::dvec4> valuesOf(const osg::Array& array, bool isNormalised);

} // namespace osgPMObjects
