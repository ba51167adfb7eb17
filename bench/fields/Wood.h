// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgPMObjects/ProgressiveField>

namespace fieldbench
{

/// Makes the models of a landscape as progressive shapes with the states of the scenery. Cost: some seconds.
std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>> landscapeShapes();

/// Scatters instances evenly over a square of the plane z = 0 about the origin, 85 of 100 trees and bushes,
/// at least `spacingM` apart, with random attitude and scale. The same numbers give the same instances.
std::vector<osgPMObjects::FieldInstance> scattered(std::uint32_t count, std::uint32_t kinds, double spacingM);

} // namespace fieldbench
