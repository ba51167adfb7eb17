// SPDX-License-Identifier: Apache-2.0
#include "EntityModel.h"

#include <map>
#include <string>

#include <osgSky/SunShadows>

#include "ModelFile.h"
#include "scenery/nodes/DefaultAircraft.h"
#include "scenery/nodes/EntityLook.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/Pose.h"

namespace trainer
{

namespace
{

osg::Matrixd matrixOf(const scenery::Pose& pose)
{
    const glm::dmat4 matrix = scenery::worldFromModel(pose);
    return osg::Matrixd(&matrix[0][0]); // GLM's columns are OSG's rows
}

/// The eye in a model that was read: a driver's on the left of the middle.
glm::dvec3 eyeIn(const simulation::BoundingBox& box)
{
    return box.centre + glm::dvec3(0.0, 0.2 * box.widthM, 0.32 * box.heightM);
}

} // namespace

foundation::Result<EntityModel> EntityModel::create(const simulation::ScenarioObject& object,
                                                    const std::filesystem::path& folder,
                                                    scenery::EntityShapes& shapes)
{
    EntityModel model;
    model._placed = new osg::MatrixTransform;
    model._placed->setDataVariance(osg::Object::DYNAMIC);
    const std::filesystem::path file = folder / object.model3d();
    std::error_code ignored;
    const bool isThere = std::filesystem::exists(file, ignored);
    if (!object.model3d().empty() && !isThere)
        model._notes.push_back(object.name + ": there is no " + file.string() + "; a stand-in is drawn");
    std::shared_ptr<const scenery::models::VehicleLook> vehicle;
    if (isThere && file.extension() == ".json")
    {
        const auto look = shapes.lookIn(file);
        if (!look) return look.error();
        vehicle = *look;
    }
    const scenery::EntityLook look = scenery::entityLook(object, vehicle);
    model._shape = look.shape;
    if (!object.model3d().empty() && isThere && !vehicle)
    {
        const auto loaded = readModel(file, "give " + object.name + " another model3d");
        if (!loaded) return loaded.error();
        scenery::setObjectShading(*loaded->node, scenery::Finish::matt);
        model._placed->addChild(loaded->node);
        model._notes = loaded->notes;
        model._eye = eyeIn(object.box());
    }
    else
    {
        model._generated = std::make_shared<scenery::EntityNode>(look.shape, shapes);
        model._flies = scenery::models::isAircraft(look.shape.kind);
        model._eye = model._generated->eye();
        if (model._notes.empty() && !look.note.empty()) model._notes.push_back(look.note);
    }
    model.node()->getOrCreateStateSet()->setDefine("OBJECT_BARE"); // what moves carries no snow
    return model;
}

namespace
{

/// The lamps that are on when those that actions have switched are as they say.
scenery::models::LitLamps switched(scenery::models::LitLamps lit, const simulation::EntityState& state)
{
    using Kind = scenery::models::EntityLamp::Kind;
    static const std::multimap<std::string, Kind> kLamps = {{"lowBeam", Kind::head},
                                                            {"highBeam", Kind::head},
                                                            {"daytimeRunningLights", Kind::head},
                                                            {"lowBeam", Kind::tail},
                                                            {"brakeLights", Kind::brake},
                                                            {"indicatorLeft", Kind::indicatorLeft},
                                                            {"indicatorRight", Kind::indicatorRight},
                                                            {"warningLights", Kind::indicatorLeft},
                                                            {"warningLights", Kind::indicatorRight},
                                                            {"reversingLights", Kind::reversing},
                                                            {"specialPurposeLights", Kind::warning}};
    for (const auto& [name, lamp] : state.lamps)
    {
        const auto [first, last] = kLamps.equal_range(name);
        for (auto found = first; found != last; ++found)
            lit[static_cast<std::size_t>(found->second)] = lamp.isLit;
    }
    return lit;
}

} // namespace

void EntityModel::show(const simulation::EntityState& state, const Light& light,
                       const simulation::GroundProvider& ground)
{
    // Beyond the maps that show what moves, a patch on the ground is the shadow, at any quality.
    const bool isNear = !light.eye || glm::distance(state.position, *light.eye) < light.mapsReachM;
    const bool castsByMaps = light.mapsReachM > 0.0 && (isNear || !_generated);
    node()->setNodeMask(!state.isVisible || _isHidden ? 0U
                        : castsByMaps                 ? osgSky::SunShadows::kMoves
                                                      : osgSky::SunShadows::kCastsNone);
    if (!_generated) return _placed->setMatrix(matrixOf(scenery::poseOf(state)));
    simulation::EntityState shown = state;
    if (_flies && !shown.aircraft) shown.aircraft = scenery::defaultAircraftParts(state, light.isDark);
    _lit = switched(scenery::defaultLamps(shown, light.isDark, light.timeS), state);
    _generated->setState(shown, _lit);
    if (state.isVisible && (_isHidden || !castsByMaps))
        _generated->castShadow(light.sun, ground);
    else
        _generated->shadow()->setNodeMask(0);
}

} // namespace trainer
