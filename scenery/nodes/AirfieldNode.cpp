// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/AirfieldNode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/Geometry>
#include <osgSky/Atmosphere>

#include <shaders/scenery.h>

#include "scenery/nodes/ModelMesh.h"
#include "scenery/nodes/ObjectShading.h"

namespace scenery
{

namespace
{

constexpr double kFromEdgeM = 15.0, kApartM = 9.0;
constexpr std::array<double, 4> kAnglesDeg{3.5, 3.0 + 1.0 / 6.0, 2.0 + 5.0 / 6.0,
                                           2.5}; ///< from the innermost
constexpr double kLampM = 0.5;                   ///< above the ground
constexpr double kPoleM = 6.0, kSockM = 3.6, kFullWindMps = 7.7;
const osg::Vec4f kOrange(0.90F, 0.33F, 0.06F, 1.0F), kWhite(0.92F, 0.92F, 0.90F, 1.0F),
    kGrey(0.55F, 0.56F, 0.57F, 1.0F);

osg::Vec3f vectorOf(const glm::dvec3& v)
{
    return osg::Vec3f(osg::Vec3d(v.x, v.y, v.z));
}

osg::Matrixd at(const glm::dvec3& place)
{
    return osg::Matrixd::translate(place.x, place.y, place.z);
}

struct PapiBound : public osg::Drawable::ComputeBoundingBoxCallback
{
    osg::BoundingBox computeBound(const osg::Drawable& drawable) const override
    {
        const osg::Vec3f reach(30.0F, 30.0F, 30.0F); // of the squares, seen from some kilometres
        osg::BoundingBox box = drawable.computeBoundingBox();
        box._min -= reach;
        box._max += reach;
        return box;
    }
};

/// The lights, and the housings below them, about the first unit.
osg::ref_ptr<osg::Group> papiNode(std::span<const PapiUnit> units)
{
    const osg::ref_ptr<osg::Vec3Array> middles = new osg::Vec3Array, normals = new osg::Vec3Array,
                                       across = new osg::Vec3Array;
    const osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    const osg::ref_ptr<osg::DrawElementsUShort> faces = new osg::DrawElementsUShort(GL_TRIANGLES);
    const glm::dvec3 origin = units.front().place;
    ModelMesh housings;
    for (const PapiUnit& unit : units)
    {
        const glm::dvec3 lamp = unit.place - origin + glm::dvec3(0.6 * unit.towards, kLampM);
        const osg::Vec3f middle = vectorOf(unit.place - origin);
        housings.addBox(middle + osg::Vec3f(-0.45F, -0.45F, -0.3F), middle + osg::Vec3f(0.45F, 0.45F, 0.3F),
                        kGrey);
        housings.addBox(middle + osg::Vec3f(-0.55F, -0.55F, 0.3F), middle + osg::Vec3f(0.55F, 0.55F, 0.62F),
                        kOrange);
        const auto first = static_cast<GLushort>(middles->size());
        for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}})
        {
            middles->push_back(vectorOf(lamp));
            normals->push_back(vectorOf({unit.towards, 0.0}));
            across->push_back({x, y, 0.35F});
            colours->push_back({1.0F, 1.0F, 1.0F, static_cast<float>(unit.angleDeg)});
        }
        for (const int corner : {0, 1, 2, 0, 2, 3})
            faces->push_back(static_cast<GLushort>(first + corner));
    }
    const osg::ref_ptr<osg::Geometry> lights = new osg::Geometry;
    lights->setUseDisplayList(false);
    lights->setUseVertexBufferObjects(true);
    lights->setVertexArray(middles);
    lights->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    lights->setTexCoordArray(0, across, osg::Array::BIND_PER_VERTEX);
    lights->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    lights->addPrimitiveSet(faces);
    lights->setComputeBoundingBoxCallback(new PapiBound);
    osg::StateSet* const state = lights->getOrCreateStateSet();
    state->setAttributeAndModes(makePapiProgram());
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setRenderBinDetails(11, "DepthSortedBin");
    const osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(at(origin));
    const osg::ref_ptr<osg::Geode> boxes = new osg::Geode;
    boxes->addDrawable(housings.geometry());
    setObjectShading(*boxes, Finish::matt);
    place->addChild(boxes);
    place->addChild(lights);
    return place;
}

osg::ref_ptr<osg::Node> poleNode()
{
    ModelMesh mesh;
    mesh.addBar({0.0F, 0.0F, -0.5F}, {0.0F, 0.0F, static_cast<float>(kPoleM)}, 0.06F, kGrey);
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(mesh.geometry());
    return geode;
}

/// Along x from its mouth: five bands, narrower towards the end.
osg::ref_ptr<osg::Node> sockNode()
{
    constexpr int kBands = 5, kSides = 16;
    ModelMesh mesh;
    const auto ring = [](double share)
    {
        Ring points;
        const double radius = std::lerp(0.45, 0.22, share);
        for (int side = 0; side < kSides; ++side)
        {
            const double angle = 2.0 * std::numbers::pi * side / kSides;
            points.push_back(
                vectorOf({0.1 + share * kSockM, radius * std::cos(angle), radius * std::sin(angle)}));
        }
        return points;
    };
    for (int band = 0; band < kBands; ++band)
    {
        const std::array<Ring, 2> rings{ring(static_cast<double>(band) / kBands),
                                        ring(static_cast<double>(band + 1) / kBands)};
        mesh.addLoft(rings, band % 2 == 0 ? kOrange : kWhite);
    }
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(mesh.geometry());
    return geode;
}

} // namespace

std::vector<PapiUnit> papiUnits(const glm::dvec2& threshold, const glm::dvec2& landing, double lengthM,
                                double widthM)
{
    const double aheadM = lengthM < 800.0    ? 150.0
                          : lengthM < 1200.0 ? 250.0
                          : lengthM < 2400.0 ? 300.0
                                             : 400.0;
    const glm::dvec2 left(-landing.y, landing.x);
    std::vector<PapiUnit> units;
    for (std::size_t i = 0; i < kAnglesDeg.size(); ++i)
    {
        const double outM = 0.5 * widthM + kFromEdgeM + kApartM * static_cast<double>(i);
        units.push_back({{threshold + aheadM * landing + outM * left, 0.0}, -landing, kAnglesDeg[i]});
    }
    return units;
}

osg::ref_ptr<osg::Program> makePapiProgram()
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("PAPI");
    const std::string version = "#version 130\n";
    program->addShader(new osg::Shader(osg::Shader::VERTEX, version + shaders::kPapiVertexMain));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT,
                                       version + osgSky::Atmosphere::glslFunctions() + shaders::kGlowMain));
    return program;
}

AirfieldNode::AirfieldNode(std::span<const PapiUnit> papis, std::span<const glm::dvec3> socks)
{
    for (std::size_t i = 0; i < papis.size(); i += kAnglesDeg.size())
        _root->addChild(papiNode(papis.subspan(i, std::min(kAnglesDeg.size(), papis.size() - i))));
    if (socks.empty()) return;
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    setObjectShading(*group, Finish::matt);
    group->getStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    const osg::ref_ptr<osg::Node> pole = poleNode(), sock = sockNode();
    for (const glm::dvec3& foot : socks)
    {
        const osg::ref_ptr<osg::MatrixTransform> standing = new osg::MatrixTransform(at(foot));
        standing->addChild(pole);
        group->addChild(standing);
        _tops.push_back(foot + glm::dvec3(0.0, 0.0, kPoleM));
        _socks.push_back(new osg::MatrixTransform);
        _socks.back()->addChild(sock);
        group->addChild(_socks.back());
    }
    _root->addChild(group);
    setWind({0.0, 0.0});
}

void AirfieldNode::setWind(const glm::dvec2& windMps)
{
    const double share = std::min(glm::length(windMps) / kFullWindMps, 1.0);
    const double hanging = std::lerp(80.0, 2.0, share) * std::numbers::pi / 180.0;
    const double heading = share > 0.0 ? std::atan2(windMps.y, windMps.x) : 0.0;
    for (std::size_t i = 0; i < _socks.size(); ++i)
        _socks[i]->setMatrix(osg::Matrixd::rotate(hanging, osg::Vec3d(0, 1, 0)) *
                             osg::Matrixd::rotate(heading, osg::Vec3d(0, 0, 1)) * at(_tops[i]));
}

} // namespace scenery
