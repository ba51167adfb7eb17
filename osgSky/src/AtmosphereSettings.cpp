// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <foundation/SettingsCheck.h>

#include <osgSky/Atmosphere>

namespace osgSky
{

foundation::Outcome checkSettings(const AtmosphereSettings& settings)
{
    constexpr double kLowest = std::numeric_limits<double>::lowest();
    const osg::Vec3f fog = settings.fogColour.value_or(osg::Vec3f());
    foundation::SettingsCheck check("Atmosphere");
    check.above("sunDirectionWorld", settings.sunDirectionWorld.length(), 0.0)
        .within("visibilityM", settings.visibilityM, 1.0)
        .within("hazeBaseM", settings.hazeBaseM, kLowest)
        .within("sunIntensity", settings.sunIntensity, 0.0)
        .within("cloudCover", settings.cloudCover, 0.0, 1.0)
        .within("moonlight", settings.moonlight, 0.0, 1.0);
    for (const float radiance : {fog.x(), fog.y(), fog.z()})
        check.within("fogColour", radiance, 0.0);
    return check.outcome();
}

} // namespace osgSky
