// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/SceneryShapes.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>

#include <foundation/ForEachAtOnce.h>

#include <osg/Notify>
#include <osgDB/FileNameUtils>

#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/PmNode>
#include <osgPMObjects/ReadModel>

#include "scenery/models/Catalogue.h"
#include "scenery/nodes/ProgressiveModel.h"

namespace scenery
{

namespace
{

using osgPMObjects::ProgressiveShape;
namespace core = osgPMObjects::core;

Stance stanceOf(models::Kind kind)
{
    return kind >= models::Kind::saloon ? Stance::tilted : Stance::upright;
}

foundation::Result<osg::ref_ptr<const ProgressiveShape>> shapeOfPm(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return foundation::Error{file, "cannot be opened", "check that it exists and may be read"};
    const auto node = osgPMObjects::readPmNode(stream, file);
    if (!node) return node.error();
    return osg::ref_ptr<const ProgressiveShape>((*node)->shape());
}

/// Foreign loaders may crash or hang: they are run in a child process.
foundation::Result<osg::ref_ptr<const ProgressiveShape>> shapeOfFile(const std::string& file)
{
    if (osgDB::getLowerCaseFileExtension(file) == "pm") return shapeOfPm(file);
    const auto node = osgPMObjects::readModelNode(file);
    if (!node) return node.error();
    for (const std::string& note : (*node)->getDescriptions())
        if (note.ends_with(" is missing")) OSG_WARN << file << ": " << note << std::endl;
    osgPMObjects::MakeProgressiveSettings settings;
    settings.arrangement.arrangement = core::Arrangement::plain;
    const auto made = osgPMObjects::makeProgressive(**node, file, settings);
    if (!made) return made.error();
    return osg::ref_ptr<const ProgressiveShape>(made->node->shape());
}

/// A model of a file need not stand on z = 0.
double lowestOf(const core::Mesh& mesh)
{
    double lowest = std::numeric_limits<double>::max();
    for (const glm::dvec3& position : mesh.positions)
        lowest = std::min(lowest, position.z);
    return mesh.positions.empty() ? 0.0 : lowest;
}

foundation::Outcome readFiles(const std::vector<SceneryObject>& objects, SceneryShapes& made)
{
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        if (objects[i].kind) continue;
        const auto shape = shapeOfFile(objects[i].file);
        if (!shape) return shape.error();
        made.shapes[i] = *shape;
        core::Mesh mesh;
        mesh.positions = (*shape)->progressive().mesh.positions;
        made.groundZM[i] = lowestOf(mesh);
        for (glm::dvec3& position : mesh.positions)
            position.z -= made.groundZM[i];
        made.measures[i] = measuresOf(mesh, 0.0, Stance::upright);
    }
    return foundation::success();
}

} // namespace

foundation::Result<SceneryShapes> makeSceneryShapes(const std::vector<SceneryObject>& objects)
{
    const auto begin = std::chrono::steady_clock::now();
    SceneryShapes made;
    made.shapes.resize(objects.size());
    made.measures.resize(objects.size());
    made.groundZM.resize(objects.size());
    if (const auto read = readFiles(objects, made); !read) return read.error();

    std::vector<std::size_t> places; // of those that are generated
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (objects[i].kind) places.push_back(i);
    std::vector<models::Model> generated(places.size());
    foundation::forEachAtOnce(places.size(),
                              [&](std::size_t i)
                              {
                                  const SceneryObject& object = objects[places[i]];
                                  generated[i] = models::generate(*object.kind, object.seed);
                                  made.measures[places[i]] = measuresOf(
                                      generated[i].mesh, generated[i].foundationM, stanceOf(*object.kind));
                              });
    const auto shapes = makeProgressiveModels(std::move(generated));
    for (std::size_t i = 0; i < places.size(); ++i)
        made.shapes[places[i]] = shapes[i];
    made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return made;
}

} // namespace scenery
