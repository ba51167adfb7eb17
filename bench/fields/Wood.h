// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgPMObjects/ProgressiveField>

namespace fieldbench
{

/// The models of a landscape, as progressive shapes with the trainer's own states. Cost: some seconds.
std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>> landscapeShapes();

/// Instances of them, 85 of 100 trees and bushes, scattered evenly over a square of the plain z = 0 about 0, at least `spacingM` apart, turned and
/// scaled by chance; the same for the same numbers.
std::vector<osgPMObjects::FieldInstance> scattered(std::uint32_t count, std::uint32_t kinds, double spacingM);

} // namespace fieldbench
