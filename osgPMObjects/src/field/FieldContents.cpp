// SPDX-License-Identifier: Apache-2.0
#include "FieldContents.h"

#include <algorithm>
#include <cmath>

namespace osgPMObjects
{

namespace
{

using foundation::Error;

foundation::Outcome checkKind(const std::string& place, const FieldKind& kind)
{
    if (!kind.shape)
        return Error{place, "has no shape", "give every kind one, of makeProgressive() or a .pm file"};
    const auto levels = static_cast<std::uint32_t>(kind.shape->levels().faces.size());
    if (foundation::Outcome checked = core::checkSettings(kind.selection, levels); !checked)
        return Error{place, checked.error().place + ' ' + checked.error().what, checked.error().remedy};
    if (foundation::Outcome checked = core::checkSettings(kind.switching); !checked)
        return Error{place, checked.error().place + ' ' + checked.error().what, checked.error().remedy};
    return foundation::success();
}

/// Whether pictures cut holes into a shape: an alpha test, which comes after the shader, would see alphas that fade.
bool hasCutOuts(const ProgressiveShape& shape)
{
    const auto isTested = [](const ProgressiveShape::Group& group)
    { return group.state && (group.state->getMode(GL_ALPHA_TEST) & osg::StateAttribute::ON) != 0; };
    return std::any_of(shape.groups().begin(), shape.groups().end(), isTested);
}

bool isSound(const FieldInstance& instance)
{
    const osg::Quat& q = instance.attitude;
    return instance.position.valid() && std::isfinite(instance.scale) && instance.scale > 0.0 &&
           std::abs(q.length2() - 1.0) < 1e-3 && instance.priority.importance > 0.0;
}

} // namespace

foundation::Outcome checkContents(const std::string& name, const std::vector<FieldKind>& kinds,
                                  const std::vector<FieldInstance>& instances)
{
    const std::string field = name.empty() ? "field" : name;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (foundation::Outcome checked = checkKind(field + ", kind " + std::to_string(i), kinds[i]);
            !checked)
            return checked;
    for (std::size_t i = 0; i < instances.size(); ++i)
    {
        const std::string place = field + ", instance " + std::to_string(i);
        if (instances[i].kind >= kinds.size())
            return Error{place, "is of kind " + std::to_string(instances[i].kind) + ", which is not there",
                         "there are " + std::to_string(kinds.size()) + " kinds, counted from 0"};
        if (!isSound(instances[i]))
            return Error{place,
                         "its place is not finite, or its attitude no rotation, or its scale or importance "
                         "not above 0",
                         "give finite metres, a unit quaternion, and a scale and importance above 0"};
    }
    return foundation::success();
}

std::vector<osg::ref_ptr<FieldMesh>> meshesOf(const std::vector<FieldKind>& kinds,
                                              const std::vector<osg::ref_ptr<FieldMesh>>& known)
{
    std::vector<osg::ref_ptr<FieldMesh>> all = known, meshes;
    for (const FieldKind& kind : kinds)
    {
        const auto found = std::find_if(all.begin(), all.end(),
                                        [&](const auto& mesh) { return &mesh->shape() == kind.shape.get(); });
        meshes.push_back(found != all.end() ? *found : osg::ref_ptr<FieldMesh>(new FieldMesh(kind.shape)));
        all.push_back(meshes.back());
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

} // namespace osgPMObjects
