// SPDX-License-Identifier: Apache-2.0
// Contrast after d metres is exp(-3 d / V), for the ground, a road and an object alike. Over black air the
// light that comes from a surface shows it (in fog, where the air itself is black to 0.3 %): light that is as
// much stronger as the law says it is weakened must look the same.
#include <cmath>

#include <gtest/gtest.h>

#include <osg/Geode>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "FeatureScene.h"
#include "RoadTexts.h"
#include "scenery/nodes/ModelMesh.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/RoadShading.h"

namespace
{

using namespace osgSky;
using namespace osgTerrainROAM;

constexpr double kAwayM = 500.0;

/// Undoes displayColour() for the green of a pixel, 0…255.
double lightOfGreen(double shown, double exposure)
{
    const double share = shown / 255.0;
    return std::pow(-std::log(1.0 - std::min(share * share, 0.998)), 1.0 / 1.125) / exposure;
}

/// Looks straight down on a surface from 500 m above it.
class Seen
{
public:
    explicit Seen(osg::Node* surface) : _root(new osg::Group), _atmosphere(new Atmosphere)
    {
        _atmosphere->addUniformsTo(*_root->getOrCreateStateSet());
        _root->addChild(surface);
        if (auto* const terrain = dynamic_cast<RoamTerrain*>(surface)) terrain->setAtmosphere(_atmosphere);
        _bounds = surface->getBound();
    }

    /// Makes the air weaken light more than its visibility says: the mutation.
    void thicken(float factor) { _factor = factor; }

    /// What of the light that a surface sends out arrives, times its reflectance.
    double through(double visibilityM)
    {
        AtmosphereSettings air;
        air.sunDirectionWorld = {0.0, 0.0, 1.0};
        air.visibilityM = visibilityM;
        air.fogColour = osg::Vec3f();
        const double wanted = 2.0 * std::exp(3.0 * kAwayM / visibilityM);
        air.sunIntensity = wanted / atmosphereLight(air).sun.y();
        EXPECT_TRUE(_atmosphere->setSettings(air));
        osg::StateSet& state = *_root->getStateSet();
        state.getUniform("atmosphereExtinction")->set(_atmosphere->light().extinction * _factor);
        const osg::Vec3d below = _bounds.center();
        const osg::ref_ptr<osg::Image> picture = featurescene::Camera(_root).picture(
            below + osg::Vec3d(0.0, 0.0, kAwayM), {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0});
        double sum = 0.0;
        for (int x = -8; x < 8; ++x)
            for (int y = -2; y < 2; ++y)
                sum += lightOfGreen(
                    picture->data(featurescene::kWidthPx / 2 + x, featurescene::kHeightPx / 2 + y)[1],
                    _atmosphere->light().exposure);
        return sum / 64.0 / wanted;
    }

    /// The number in the exponent of the law, between two visibilities: 3.
    double exponent(double visibilityM, double otherM)
    {
        return std::log(through(otherM) / through(visibilityM)) / (kAwayM / visibilityM - kAwayM / otherM);
    }

private:
    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<Atmosphere> _atmosphere;
    osg::BoundingSphere _bounds;
    float _factor = 1.0F;
};

osg::ref_ptr<osg::Node> slab()
{
    scenery::ModelMesh mesh;
    mesh.addBox({-100.0F, -100.0F, -0.1F}, {100.0F, 100.0F, 0.0F}, {0.3F, 0.3F, 0.3F, 1.0F});
    const osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(mesh.geometry());
    scenery::setObjectShading(*node, scenery::Finish::matt);
    return node;
}

/// A road 100 m long and 7 m wide: some 4 pixels of the picture high.
osg::ref_ptr<osg::Node> road()
{
    using namespace roadtexts;
    const auto network = std::make_shared<const osgRoads::core::RoadNetwork>(
        sound(roadtexts::network(roadtexts::road("1", 100.0, straightPlan(100.0) + twoLanes()))));
    const osgRoads::core::PlacedNetwork placed(network);
    return scenery::makeRoadNode(
        std::make_shared<const osgRoads::core::RoadMesh>(osgRoads::core::buildRoadMesh(placed)));
}

void expectLaw(const osg::ref_ptr<osg::Node>& surface)
{
    Seen seen(surface);
    for (const double visibilityM : {400.0, 250.0})
        EXPECT_NEAR(seen.exponent(visibilityM, 600.0), 3.0, 0.06) << visibilityM;
}

} // namespace

TEST(VisibilityLaw, HoldsForTheGround)
{
    expectLaw(featurescene::plain({}));
}

TEST(VisibilityLaw, HoldsForARoad)
{
    expectLaw(road());
}

TEST(VisibilityLaw, HoldsForAnObject)
{
    expectLaw(slab());
}

TEST(VisibilityLaw, AirAFifthThickerWouldBeSeen)
{
    Seen seen(slab());
    seen.thicken(1.2F);
    EXPECT_GT(seen.exponent(300.0, 600.0), 3.3);
}
