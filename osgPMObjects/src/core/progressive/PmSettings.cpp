// SPDX-License-Identifier: Apache-2.0
#include <foundation/SettingsCheck.h>

#include <osgPMObjects/core/progressive/PmFile.h>

namespace osgPMObjects::core
{

foundation::Outcome checkSettings(const PmSettings& settings)
{
    return foundation::SettingsCheck("pm file")
        .within("stepSections", settings.stepSections, 1, PmSettings::kMostStepSections)
        .outcome();
}

} // namespace osgPMObjects::core
