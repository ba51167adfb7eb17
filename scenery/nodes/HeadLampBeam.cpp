// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/HeadLampBeam.h"

#include <optional>

namespace scenery
{

namespace
{

/// Between the head lamps. Absent: there are none.
std::optional<glm::dvec3> middleOf(const std::vector<models::EntityLamp>& lamps)
{
    glm::dvec3 sum(0.0);
    int count = 0;
    for (const models::EntityLamp& lamp : lamps)
    {
        if (lamp.kind != models::EntityLamp::Kind::head || !lamp.looksAhead) continue;
        sum += lamp.middle;
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
}

} // namespace

HeadLampBeam::HeadLampBeam(osg::StateSet& scene)
    : _scene(&scene),
      _at(new osg::Uniform("headLampAt", osg::Vec3f())),
      _axes(new osg::Uniform(osg::Uniform::FLOAT_MAT3, "headLampAxes"))
{
    _scene->addUniform(_at);
    _scene->addUniform(_axes);
}

void HeadLampBeam::show(const Pose& vehicle, const std::vector<models::EntityLamp>& lamps, bool isLit)
{
    const auto middle = isLit ? middleOf(lamps) : std::nullopt;
    if (!middle) return _scene->removeDefine("HEAD_LAMPS");
    _scene->setDefine("HEAD_LAMPS");
    const glm::dvec3 at = vehicle.worldFromBodyPoint(*middle);
    _at->set(osg::Vec3f(osg::Vec3d(at.x, at.y, at.z)));
    osg::Matrix3 axes;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 3; ++i)
            axes[3 * i + axis] = static_cast<float>(vehicle.worldFromBody[axis][i]); // by columns
    _axes->set(axes);
}

} // namespace scenery
