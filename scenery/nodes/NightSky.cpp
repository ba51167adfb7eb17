// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/NightSky.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <foundation/Angle.h>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/PointSprite>
#include <osg/Program>
#include <osgSky/Atmosphere>

#include <osgTraversal/DrawOrder>
#include <shaders/scenery.h>

#include "scenery/nodes/NoBound.h"
#include "simulation/environment/BrightStars.h"

namespace scenery
{

namespace
{

constexpr double kRiseOfDarkness = 0.62; ///< magnitudes a degree of the sun
constexpr double kFaintestAtSunset = -3.0, kFaintest = 6.5, kLostByMoon = 1.2;

/// The colour of a star's light, of equal brightness for all. By the temperature that the colour index tells
/// (Ballesteros, *New insights into black bodies*, 2012), in three steps of Planck's colours.
osg::Vec3f starColour(double colourIndex)
{
    const auto share = static_cast<float>(std::clamp((colourIndex + 0.3) / 1.9, 0.0, 1.0));
    const osg::Vec3f blue(0.72F, 0.83F, 1.15F), white(1.0F, 0.98F, 0.95F), orange(1.20F, 0.86F, 0.58F);
    constexpr float kWhiteShare = 0.35F;
    return share < kWhiteShare ? blue + (white - blue) * (share / kWhiteShare)
                               : white + (orange - white) * ((share - kWhiteShare) / (1.0F - kWhiteShare));
}

osg::ref_ptr<osg::Geometry> behindAll()
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setCullingActive(false);
    geometry->setComputeBoundingBoxCallback(new NoBound);
    return geometry;
}

osg::ref_ptr<osg::Node> inTheSky(const char* name, osg::Geometry* geometry, const char* vertex,
                                 const std::string& fragment)
{
    const osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->setName(name);
    node->setCullingActive(false);
    node->addDrawable(geometry);
    const osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName(name);
    program->addShader(new osg::Shader(osg::Shader::VERTEX, vertex));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, "#version 130\n" + fragment));
    osg::StateSet* const state = node->getOrCreateStateSet();
    state->setAttributeAndModes(program);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 1.0, 1.0, false));
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setDataVariance(osg::Object::DYNAMIC);
    return node;
}

osg::ref_ptr<osg::Node> makeStars()
{
    const osg::ref_ptr<osg::Geometry> points = behindAll();
    const osg::ref_ptr<osg::Vec4Array> places = new osg::Vec4Array; // direction and magnitude
    const osg::ref_ptr<osg::Vec3Array> colours = new osg::Vec3Array;
    for (const simulation::BrightStar& star : simulation::brightStars())
    {
        const double ascension = foundation::radiansOf(star.rightAscensionDeg);
        const double declination = foundation::radiansOf(star.declinationDeg);
        places->push_back(osg::Vec4(static_cast<float>(std::cos(declination) * std::cos(ascension)),
                                    static_cast<float>(std::cos(declination) * std::sin(ascension)),
                                    static_cast<float>(std::sin(declination)),
                                    static_cast<float>(star.magnitude)));
        colours->push_back(starColour(star.colourIndex));
    }
    points->setVertexArray(places);
    points->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    points->addPrimitiveSet(new osg::DrawArrays(GL_POINTS, 0, static_cast<int>(places->size())));
    const osg::ref_ptr<osg::Node> stars = inTheSky("stars", points, shaders::kStarsVert, shaders::kStarsMain);
    osg::StateSet* const state = stars->getStateSet();
    state->setMode(GL_VERTEX_PROGRAM_POINT_SIZE, osg::StateAttribute::ON);
    state->addUniform(new osg::Uniform("drawnPixels", 1.0F)); // cameras tell other sides
    state->setTextureAttributeAndModes(0, new osg::PointSprite);
    state->setRenderBinDetails(osgTraversal::DrawOrder::kSky + 1, "RenderBin");
    return stars;
}

osg::ref_ptr<osg::Node> makeMoon()
{
    const osg::ref_ptr<osg::Geometry> square = behindAll();
    const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {-1.0F, 1.0F}, {1.0F, 1.0F}})
        corners->push_back({x, y, 0.0F});
    square->setVertexArray(corners);
    square->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
    const osg::ref_ptr<osg::Node> moon =
        inTheSky("moon", square, shaders::kMoonVert,
                 osgSky::Atmosphere::glslFunctions() + std::string(shaders::kMoonMain));
    moon->getStateSet()->setRenderBinDetails(osgTraversal::DrawOrder::kSky + 2, "RenderBin");
    return moon;
}

} // namespace

NightSky::NightSky() : _root(new osg::Group), _stars(makeStars()), _moon(makeMoon())
{
    _root->setName("night sky");
    _root->setCullingActive(false);
    _root->addChild(_stars);
    _root->addChild(_moon);
    show(glm::dmat3(1.0), 90.0, {});
}

double NightSky::faintestSeen(double sunElevationDeg, double moonlight)
{
    return std::clamp(kFaintestAtSunset - kRiseOfDarkness * sunElevationDeg, kFaintestAtSunset, kFaintest) -
           kLostByMoon * moonlight;
}

void NightSky::show(const glm::dmat3& worldFromStars, double sunElevationDeg,
                    const simulation::MoonSight& moon)
{
    const double faintest = faintestSeen(sunElevationDeg, simulation::moonlightOf(moon));
    _stars->setNodeMask(sunElevationDeg < -1.0 ? ~0U : 0U);
    osg::Matrix3 turn;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            turn(column, row) = static_cast<float>(worldFromStars[column][row]);
    osg::StateSet& stars = *_stars->getStateSet();
    stars.getOrCreateUniform("worldFromStars", osg::Uniform::FLOAT_MAT3)->set(turn);
    stars.getOrCreateUniform("faintestSeen", osg::Uniform::FLOAT)->set(static_cast<float>(faintest));
    _moon->setNodeMask(moon.towards.z > -0.01 ? ~0U : 0U);
    osg::StateSet& disc = *_moon->getStateSet();
    disc.getOrCreateUniform("moonDirection", osg::Uniform::FLOAT_VEC3)
        ->set(osg::Vec3f(osg::Vec3d(moon.towards.x, moon.towards.y, moon.towards.z)));
    constexpr double kRadiusKm = 1737.4;
    disc.getOrCreateUniform("moonRadius", osg::Uniform::FLOAT)
        ->set(static_cast<float>(kRadiusKm / moon.distanceKm));
    const double day = std::clamp((sunElevationDeg + 9.0) / 10.0, 0.0, 1.0);
    disc.getOrCreateUniform("moonInDay", osg::Uniform::FLOAT)->set(static_cast<float>(day));
}

} // namespace scenery
