// SPDX-License-Identifier: Apache-2.0
#include "FieldContents.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <foundation/ForEachAtOnce.h>

#include "../settings/ErrorPlace.h"

namespace osgPMObjects
{

namespace
{

using foundation::Error;

foundation::Outcome checkKind(const std::string& place, const FieldKind& kind)
{
    if (!kind.shape)
        return Error{place + ".shape", "there is none",
                     "give the shape of makeProgressive() or of a .pm file"};
    const auto levels = static_cast<std::uint32_t>(kind.shape->levels().faces.size());
    const foundation::Outcome checked = at(place + ".selection", core::checkSettings(kind.selection, levels));
    return checked ? at(place + ".switching", core::checkSettings(kind.switching)) : checked;
}

/// `placeOf`: makes the place of an error; most instances have none.
template<class PlaceOf>
foundation::Outcome checkInstance(const PlaceOf& placeOf, const FieldInstance& instance, std::size_t kinds)
{
    if (instance.kind >= kinds)
        return Error{placeOf() + ".kind", "there is no kind " + std::to_string(instance.kind),
                     "give a number below " + std::to_string(kinds)};
    const osg::Vec3d& p = instance.position;
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
        return Error{placeOf() + ".position", "a coordinate is not finite", "give finite coordinates"};
    constexpr double kLengthTolerance = 1e-3;
    if (!(std::abs(instance.attitude.length2() - 1.0) < kLengthTolerance))
        return Error{placeOf() + ".attitude", "it is not a rotation", "give a quaternion of unit length"};
    if (!std::isfinite(instance.scale) || instance.scale <= 0.0)
        return Error{placeOf() + ".scale", "it cannot be " + std::to_string(instance.scale),
                     "give a number above 0"};
    const foundation::Outcome checked = core::checkSettings(instance.priority);
    return checked ? checked : at(placeOf() + ".priority", checked);
}

/// Whether textures cut holes into a shape. The alpha test runs after the shader, so it would also discard
/// fading fragments.
bool hasCutOuts(const ProgressiveShape& shape)
{
    const auto isTested = [](const ProgressiveShape::Group& group)
    { return group.state && (group.state->getMode(GL_ALPHA_TEST) & osg::StateAttribute::ON) != 0; };
    return std::any_of(shape.groups().begin(), shape.groups().end(), isTested);
}

} // namespace

foundation::Outcome checkContents(const std::vector<FieldKind>& kinds,
                                  const std::vector<FieldInstance>& instances)
{
    const auto placeOf = [](const char* list, std::size_t i)
    { return std::string("ProgressiveField.") + list + "[" + std::to_string(i) + "]"; };
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (foundation::Outcome checked = checkKind(placeOf("kinds", i), kinds[i]); !checked) return checked;
    for (std::size_t i = 0; i < instances.size(); ++i)
        if (foundation::Outcome checked =
                checkInstance([&] { return placeOf("instances", i); }, instances[i], kinds.size());
            !checked)
            return checked;
    return foundation::success();
}

std::vector<osg::ref_ptr<FieldMesh>> meshesOf(const std::vector<FieldKind>& kinds,
                                              const std::vector<osg::ref_ptr<FieldMesh>>& known)
{
    std::map<const ProgressiveShape*, osg::ref_ptr<FieldMesh>> all;
    for (const osg::ref_ptr<FieldMesh>& mesh : known)
        all.emplace(&mesh->shape(), mesh);
    std::vector<osg::ref_ptr<const ProgressiveShape>> missing;
    for (const FieldKind& kind : kinds)
        if (all.emplace(kind.shape.get(), nullptr).second) missing.push_back(kind.shape);
    std::vector<osg::ref_ptr<FieldMesh>> made(missing.size());
    foundation::forEachAtOnce(missing.size(), [&](std::size_t i) { made[i] = new FieldMesh(missing[i]); });
    for (std::size_t i = 0; i < missing.size(); ++i)
        all[missing[i].get()] = made[i];
    std::vector<osg::ref_ptr<FieldMesh>> meshes;
    for (const FieldKind& kind : kinds)
    {
        meshes.push_back(all[kind.shape.get()]);
        if (kind.switching.method == core::SwitchMethod::geomorph) meshes.back()->addTargets();
    }
    return meshes;
}

std::vector<core::FieldModel> modelsOf(const std::vector<FieldKind>& kinds,
                                       const std::vector<osg::ref_ptr<FieldMesh>>& meshes)
{
    std::vector<core::FieldModel> models;
    for (std::size_t i = 0; i < kinds.size(); ++i)
    {
        const ProgressiveShape& shape = *kinds[i].shape;
        core::FieldModel& model = models.emplace_back();
        model.table = &shape.levels();
        model.ladder = &meshes[i]->ladder();
        model.facing = &shape.facing();
        model.sphere = shape.sphere();
        const osg::Vec3d centre = shape.box().center();
        const osg::Vec3d half = (osg::Vec3d(shape.box()._max) - osg::Vec3d(shape.box()._min)) * 0.5;
        model.box = {{centre.x(), centre.y(), centre.z()}, glm::dmat3(1.0), {half.x(), half.y(), half.z()}};
        model.origin = {shape.origin().x(), shape.origin().y(), shape.origin().z()};
        model.selection = kinds[i].selection;
        model.switching = kinds[i].switching;
        if (hasCutOuts(shape)) model.switching.profile = core::BlendProfile::cross;
    }
    return models;
}

std::vector<core::FieldObject> objectsOf(const std::vector<FieldInstance>& instances)
{
    std::vector<core::FieldObject> objects;
    objects.reserve(instances.size());
    for (const FieldInstance& instance : instances)
    {
        const osg::Vec3d& p = instance.position;
        const osg::Quat& q = instance.attitude;
        objects.push_back({{p.x(), p.y(), p.z()},
                           glm::dquat(q.w(), q.x(), q.y(), q.z()),
                           instance.scale,
                           instance.kind,
                           instance.priority});
    }
    return objects;
}

std::vector<FieldInstance> instancesOf(const core::Field& field)
{
    std::vector<FieldInstance> instances(field.objects().size());
    for (std::uint32_t i = 0; i < instances.size(); ++i)
    {
        const core::FieldObject& object = field.objects()[i];
        const glm::dquat& q = object.attitude;
        instances[field.numberOf(i)] = {{object.position.x, object.position.y, object.position.z},
                                        {q.x, q.y, q.z, q.w},
                                        object.scale,
                                        object.model,
                                        object.priority};
    }
    return instances;
}

} // namespace osgPMObjects
