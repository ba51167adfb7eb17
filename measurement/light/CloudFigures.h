// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "measurement/light/LightFigure.h"
#include "scenery/clouds/CloudVolume.h"

namespace measurement
{

/// What is measured of clouds.
struct CloudParts
{
    std::function<scenery::clouds::CloudVolume(const simulation::CloudLayer&, std::uint32_t seed)> make =
        scenery::clouds::makeCloudVolume;
    std::vector<simulation::CloudKind> kinds{simulation::CloudKind::cumulus,
                                             simulation::CloudKind::stratocumulus,
                                             simulation::CloudKind::stratus, simulation::CloudKind::cirrus};
};

/// Returns how many eighths of 2000 rays straight up meet cloud of an optical depth above 0.1.
double oktasOf(const scenery::clouds::CloudVolume& volume);

/// Returns the height, in metres, below which a tenth of the columns with cloud begin, with a tenth of the
/// density that the kind has well within. No number without cloud.
double lowestCloudM(const scenery::clouds::CloudVolume& volume);

/// Measures cover and base of each kind of cloud, 0 to 8 oktas. Cost: makes nine layers of each
/// kind.
LightFigures cloudFigures(const CloudParts& parts = {});

} // namespace measurement
