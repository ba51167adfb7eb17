// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/ProgressiveModel.h"

#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include <foundation/ForEachAtOnce.h>
#include <foundation/KeptResults.h>

#include <osg/Matrixd>

#include <osgPMObjects/core/field/FieldLevels.h>
#include <osgPMObjects/core/progressive/PmFile.h>
#include <osgPMObjects/core/simplify/Simplifiable.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "scenery/nodes/PaintedTexture.h"
#include "scenery/nodes/SurfaceState.h"

namespace scenery
{

namespace core = osgPMObjects::core;

namespace
{

/// Everything that levels follow from.
foundation::ContentMark markOf(const core::Mesh& mesh)
{
    foundation::ContentMark mark;
    mark.add(mesh.positions).add(mesh.wedgePositions).add(mesh.normals).add(mesh.colours).add(mesh.faces);
    for (const auto& coordinates : mesh.texCoords)
        mark.add(coordinates);
    for (const core::Material& material : mesh.materials)
    {
        mark.add(material.name).addWord(material.state).addWord(material.attributes).addWord(material.unseen);
        mark.addWord((material.isTwoSided ? 1U : 0U) + (material.litFromBothSides ? 2U : 0U) +
                     (material.isTransparent ? 4U : 0U));
    }
    for (const core::Part& part : mesh.parts)
        mark.add(part.name);
    return mark;
}

/// Absent: they are not what pmBytes() wrote.
std::optional<core::ProgressiveMesh> levelsIn(std::string_view bytes)
{
    std::istringstream stream{std::string(bytes)};
    core::PmReader reader(stream, "kept levels");
    while (true)
    {
        const auto more = reader.readMore();
        if (!more) return std::nullopt;
        if (*more) continue;
        auto levels = reader.mesh();
        return levels ? std::optional(*std::move(levels)) : std::nullopt;
    }
}

core::ProgressiveMesh madeLevels(core::Mesh mesh)
{
    core::makeSimplifiable(mesh);
    const core::CollapseSequence sequence = core::simplify(mesh);
    core::ArrangementSettings settings;
    settings.arrangement = core::Arrangement::plain; // fields have index lists of their own
    return core::buildProgressiveMesh(mesh, sequence, settings);
}

core::ProgressiveMesh levelsOf(core::Mesh mesh, const foundation::ContentMark& mark,
                               const foundation::KeptResults& kept)
{
    core::PmSettings whole;
    whole.stepSections = 1;
    return kept.findOrMake(
        "levels", mark, levelsIn, [&] { return madeLevels(std::move(mesh)); },
        [&](const core::ProgressiveMesh& made) { return core::pmBytes(made, whole); });
}

core::FieldLevels fieldLevelsOf(const osgPMObjects::ProgressiveShape& shape,
                                const foundation::ContentMark& mark, const foundation::KeptResults& kept)
{
    return kept.findOrMake(
        "ladder", mark,
        [&](std::string_view bytes) { return core::fieldLevelsIn(bytes, shape.progressive()); },
        [&] { return core::FieldLevels::of(shape.progressive(), shape.levels()); }, &core::bytesOf);
}

} // namespace

core::ProgressiveMesh progressiveOf(core::Mesh mesh, const foundation::KeptResults& kept)
{
    const foundation::ContentMark mark = markOf(mesh);
    return levelsOf(std::move(mesh), mark, kept);
}

core::ProgressiveMesh progressiveOf(core::Mesh mesh)
{
    return progressiveOf(std::move(mesh), foundation::KeptResults::ofUser());
}

osg::ref_ptr<const osgPMObjects::ProgressiveShape>
fieldShapeOf(core::Mesh mesh, std::vector<osg::ref_ptr<osg::StateSet>> states,
             const foundation::KeptResults& kept)
{
    const foundation::ContentMark mark = markOf(mesh);
    const osg::ref_ptr<osgPMObjects::ProgressiveShape> shape =
        new osgPMObjects::ProgressiveShape(levelsOf(std::move(mesh), mark, kept), std::move(states));
    shape->setFieldLevels(std::make_shared<const core::FieldLevels>(fieldLevelsOf(*shape, mark, kept)));
    return shape;
}

namespace
{

/// The states of models for fields; those of equal surfaces are one.
class FieldSurfaces
{
public:
    std::vector<osg::ref_ptr<osg::StateSet>> statesOf(const models::Model& model)
    {
        std::vector<osg::ref_ptr<osg::StateSet>> states;
        for (const models::Surface& surface : model.surfaces)
        {
            osg::ref_ptr<osg::StateSet>& state = _states[{surface.painting, surface.coat, surface.look}];
            const bool isFoliage = surface.coat == models::Coat::foliage;
            if (!state)
                state = surfaceState(surface,
                                     paintedTexture(surface.painting, isFoliage, 1.0F, surface.look.get()));
            states.push_back(state);
        }
        return states;
    }

private:
    using Look = std::shared_ptr<const models::VehicleLook>;

    std::map<std::tuple<models::Painting, models::Coat, Look>, osg::ref_ptr<osg::StateSet>> _states;
};

} // namespace

std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>>
makeProgressiveModels(std::vector<models::Model> models)
{
    FieldSurfaces states; // paints, in one thread
    std::vector<std::vector<osg::ref_ptr<osg::StateSet>>> statesOf;
    for (const models::Model& model : models)
        statesOf.push_back(states.statesOf(model));
    std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>> shapes(models.size());
    const foundation::KeptResults kept = foundation::KeptResults::ofUser();
    foundation::forEachAtOnce(
        models.size(), [&](std::size_t i)
        { shapes[i] = fieldShapeOf(std::move(models[i].mesh), std::move(statesOf[i]), kept); });
    return shapes;
}

osg::Quat attitudeOf(const glm::dmat3& axes)
{
    // Columns of GLM are rows of OSG.
    return osg::Matrixd(axes[0].x, axes[0].y, axes[0].z, 0.0, axes[1].x, axes[1].y, axes[1].z, 0.0, axes[2].x,
                        axes[2].y, axes[2].z, 0.0, 0.0, 0.0, 0.0, 1.0)
        .getRotate();
}

} // namespace scenery
