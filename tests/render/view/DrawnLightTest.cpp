// SPDX-License-Identifier: Apache-2.0
// The figures of `trainer qualify light` that need pictures: each fault makes one fail.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <osg/Uniform>

#include "measurement/light/view/CloudViews.h"
#include "measurement/light/view/DrawnFigures.h"
#include "measurement/light/view/LampPictures.h"
#include "scene/SceneWeather.h"

namespace
{

using namespace measurement;

/// Multiplies a uniform of the scene.
Spoiler times(const char* name, float factor)
{
    return [=](osg::StateSet& scene)
    {
        osg::Uniform* const uniform = scene.getUniform(name);
        if (uniform->getType() == osg::Uniform::FLOAT_VEC3)
        {
            osg::Vec3f colour;
            uniform->get(colour);
            uniform->set(colour * factor);
        }
        else
        {
            float number = 0.0F;
            uniform->get(number);
            uniform->set(number * factor);
        }
    };
}

LightFigure drawnRow(const foundation::Result<LightFigures>& figures, const std::string& name)
{
    if (figures)
        for (const LightFigure& figure : *figures)
            if (figure.name.starts_with(name)) return figure;
    ADD_FAILURE() << "no figure " << name;
    return atMost("", name, std::nan(""), "", 0.0, "");
}

void expectCaughtInPictures(const LightFigures& sound, const foundation::Result<LightFigures>& faulty,
                            const std::string& row)
{
    EXPECT_TRUE(drawnRow(sound, row).passes()) << row << ": " << drawnRow(sound, row).value;
    EXPECT_FALSE(drawnRow(faulty, row).passes()) << row << ": " << drawnRow(faulty, row).value;
}

} // namespace

TEST(DrawnLight, FaultsOfLampsAreCaught)
{
    const auto sound = drawnLampFigures();
    ASSERT_TRUE(sound) << sound.error().message();
    for (const LightFigure& figure : *sound)
        EXPECT_TRUE(figure.passes()) << figure.name << ": " << figure.value;
    // Lamps that shine through other air than all else; an eye that sees less.
    expectCaughtInPictures(*sound, drawnLampFigures({}, times("atmosphereExtinction", 1.2F)),
                           "lamps in pictures: range");
    expectCaughtInPictures(*sound, drawnLampFigures({}, times("lightLeastLx", 1.2F)),
                           "lamps in pictures: range");
    LampParts parts;
    parts.position.left.headingDeg = 12.0;
    parts.shareOfStep = [](scenery::LightGroup, int step) { return step == 0 ? 0.05 : 0.2 * step; };
    parts.papi = [](const glm::dvec2& threshold, const glm::dvec2& landing, double lengthM, double widthM)
    {
        auto units = scenery::papiUnits(threshold, landing, lengthM, widthM);
        units[2].angleDeg -= 0.02;
        return units;
    };
    const auto faulty = drawnLampFigures(parts);
    for (const char* row : {"lamps in pictures: light of step", "position lamps in pictures",
                            "PAPI in pictures: angle", "lamps in pictures: pixels"})
        expectCaughtInPictures(*sound, faulty, row);
}

TEST(DrawnLight, AirForEachSurfaceIsCaught)
{
    const SceneParts scenes{[](const char* type, double mmPerHour)
                            {
                                simulation::EnvironmentState environment;
                                environment.precipitation = simulation::Precipitation{type, mmPerHour};
                                return trainer::airOf(environment).visibilityM;
                            },
                            trainer::greyUnder};
    const auto sound = drawnAirFigures(scenes);
    ASSERT_TRUE(sound) << sound.error().message();
    const auto faulty = drawnAirFigures(scenes, times("atmosphereExtinction", 1.2F));
    for (const char* surface : {"ground", "road", "object", "aircraft"})
        expectCaughtInPictures(*sound, faulty, std::string("contrast at the visibility: ") + surface);
    for (const char* row : {"contrast at the visibility in rain", "contrast at the visibility in snow"})
        expectCaughtInPictures(*sound, faulty, row);
}

TEST(DrawnLight, CloudsThatAreNotWhereTheyAreSaidToBeAreCaught)
{
    const auto made = CloudViews::create(trainer::greyUnder);
    ASSERT_TRUE(made) << made.error().message();
    CloudViews& views = **made;
    const simulation::CloudLayer sheet{simulation::CloudKind::stratus, 8, 600.0, 1000.0};
    views.setLayer(sheet);
    EXPECT_NEAR(views.drawnBaseM(), sheet.baseM, 20.0);
    simulation::CloudLayer higher = sheet;
    higher.baseM += 60.0;
    higher.topM += 60.0;
    views.setLayer(higher);
    EXPECT_GT(std::abs(views.drawnBaseM() - sheet.baseM), 20.0);
    simulation::CloudLayer more{simulation::CloudKind::cumulus, 4, 1200.0, 2000.0};
    views.setLayer(more);
    EXPECT_NEAR(views.drawnOktas(), 4.0, 0.5);
    more.oktas = 5;
    views.setLayer(more);
    EXPECT_GT(std::abs(views.drawnOktas() - 4.0), 0.5);
}
