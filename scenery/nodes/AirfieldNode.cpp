// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/AirfieldNode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <osg/Geode>
#include <osg/Geometry>
#include <osgSky/Atmosphere>

#include "scenery/nodes/ModelMesh.h"
#include "scenery/nodes/ObjectShading.h"

namespace scenery
{

namespace
{

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

/// The housings of PAPI units, about the first of them.
osg::ref_ptr<osg::Group> housingsOf(std::span<const PapiUnit> units)
{
    const glm::dvec3 origin = units.front().place;
    ModelMesh housings;
    for (const PapiUnit& unit : units)
    {
        const osg::Vec3f middle = vectorOf(unit.place - origin);
        housings.addBox(middle + osg::Vec3f(-0.45F, -0.45F, -0.3F), middle + osg::Vec3f(0.45F, 0.45F, 0.3F),
                        kGrey);
        housings.addBox(middle + osg::Vec3f(-0.55F, -0.55F, 0.3F), middle + osg::Vec3f(0.55F, 0.55F, 0.62F),
                        kOrange);
    }
    const osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(at(origin));
    const osg::ref_ptr<osg::Geode> boxes = new osg::Geode;
    boxes->addDrawable(housings.geometry());
    setObjectShading(*boxes, Finish::matt);
    place->addChild(boxes);
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

AirfieldNode::AirfieldNode(std::span<const PapiUnit> papis, std::span<const glm::dvec3> socks,
                           std::vector<LightPoint> lights)
{
    constexpr std::size_t kUnits = 4; // of one end
    for (std::size_t i = 0; i < papis.size(); i += kUnits)
        _root->addChild(housingsOf(papis.subspan(i, std::min(kUnits, papis.size() - i))));
    for (const PapiUnit& unit : papis)
        lights.push_back(lampOf(unit));
    _lights.emplace(lights);
    if (_lights->node()) _root->addChild(_lights->node());
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

void AirfieldNode::light(const LightLevels& levels)
{
    _lights->light(levels);
}

} // namespace scenery
