// SPDX-License-Identifier: Apache-2.0
// Contrast after d metres is exp(-3 d / V), for the ground, a road and an object alike.
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include <osg/Uniform>

#include "measurement/light/view/AirPictures.h"

namespace
{

using measurement::AirPictures;
using measurement::SeenSurface;

constexpr double kAwayM = 500.0;

std::unique_ptr<AirPictures> seen(SeenSurface surface)
{
    auto made = AirPictures::create(surface);
    if (!made) throw std::runtime_error(made.error().message());
    return std::move(*made);
}

/// The number in the exponent of the law: 3.
double exponent(AirPictures& pictures, double visibilityM)
{
    return -std::log(pictures.contrastLeft(kAwayM, visibilityM, 60.0)) * visibilityM / kAwayM;
}

void expectLaw(SeenSurface surface)
{
    const auto pictures = seen(surface);
    for (const double visibilityM : {600.0, 400.0, 250.0})
        EXPECT_NEAR(exponent(*pictures, visibilityM), 3.0, 0.03) << visibilityM;
}

} // namespace

TEST(VisibilityLaw, HoldsForTheGround)
{
    expectLaw(SeenSurface::ground);
}

TEST(VisibilityLaw, HoldsForARoad)
{
    expectLaw(SeenSurface::road);
}

TEST(VisibilityLaw, HoldsForAnObject)
{
    expectLaw(SeenSurface::object);
    expectLaw(SeenSurface::aircraft);
}

TEST(VisibilityLaw, AirAFifthThickerWouldBeSeen)
{
    const auto pictures = seen(SeenSurface::object);
    pictures->spoilBy(
        [](osg::StateSet& scene)
        {
            osg::Vec3f extinction;
            scene.getUniform("atmosphereExtinction")->get(extinction);
            scene.getUniform("atmosphereExtinction")->set(extinction * 1.2F);
        });
    EXPECT_GT(exponent(*pictures, 300.0), 3.3);
}
