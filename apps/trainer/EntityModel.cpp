// SPDX-License-Identifier: Apache-2.0
#include "EntityModel.h"

#include <osg/Geode>
#include <osg/ShapeDrawable>

#include "ModelFile.h"
#include "scenery/nodes/AircraftModel.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/Pose.h"

namespace trainer
{

namespace
{

/// Makes a light grey box of the size of the entity, for entities without a model.
osg::ref_ptr<osg::Node> makeBox(const simulation::BoundingBox& box)
{
    const osg::Vec3 centre(box.centre.x, box.centre.y, box.centre.z);
    const auto extent = [](double metres) { return static_cast<float>(metres > 0 ? metres : 1.0); };
    const osg::ref_ptr<osg::ShapeDrawable> shape = new osg::ShapeDrawable(
        new osg::Box(centre, extent(box.lengthM), extent(box.widthM), extent(box.heightM)));
    shape->setColor({0.6F, 0.6F, 0.6F, 1.0F});
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(shape);
    scenery::setObjectShading(*geode, scenery::Finish::matt);
    return geode;
}

osg::Matrixd matrixOf(const scenery::Pose& pose)
{
    const glm::dmat4 matrix = scenery::worldFromModel(pose);
    return osg::Matrixd(&matrix[0][0]); // GLM's columns are OSG's rows
}

} // namespace

foundation::Result<EntityModel> EntityModel::create(const simulation::ScenarioObject& object,
                                                    const std::filesystem::path& folder)
{
    EntityModel model;
    model._placed = new osg::MatrixTransform;
    model._placed->setDataVariance(osg::Object::DYNAMIC);
    const std::filesystem::path file = folder / object.model3d();
    std::error_code ignored;
    const bool isThere = std::filesystem::exists(file, ignored);
    if (!object.model3d().empty() && !isThere)
        model._note = object.name + ": there is no " + file.string() + "; a stand-in is drawn";
    if (!object.model3d().empty() && isThere)
    {
        const auto loaded = readModel(file, "give " + object.name + " another model3d");
        if (!loaded) return loaded.error();
        scenery::setObjectShading(**loaded, scenery::Finish::matt);
        model._placed->addChild(*loaded);
    }
    else if (object.isAirborne())
        model._placed->addChild(scenery::makeLightAircraft());
    else if (std::holds_alternative<simulation::Vehicle>(object.object))
        model._car = std::make_shared<scenery::CarModel>();
    else
        model._placed->addChild(makeBox(object.box()));
    return model;
}

void EntityModel::show(const simulation::EntityState& state)
{
    if (_car)
        _car->setState(state);
    else
        _placed->setMatrix(matrixOf(scenery::poseOf(state)));
}

} // namespace trainer
