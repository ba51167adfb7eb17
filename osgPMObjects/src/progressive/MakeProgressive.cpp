// SPDX-License-Identifier: Apache-2.0
#include <foundation/SettingsCheck.h>

#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/progressive/MeasureLevels.h>
#include <osgPMObjects/core/simplify/Simplifiable.h>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/MaterialLooks>

#include "../settings/ErrorPlace.h"

namespace osgPMObjects
{

foundation::Outcome checkSettings(const MakeProgressiveSettings& settings)
{
    const foundation::Outcome checked =
        foundation::SettingsCheck("MakeProgressiveSettings.simplify")
            .within("mostTexCoordDrift", settings.simplify.mostTexCoordDrift, 0.0)
            .within("joinDistance", settings.simplify.joinDistance, 0.0)
            .within("envelope", settings.simplify.envelope, 0.0)
            .outcome();
    if (!checked) return checked;
    if (settings.ladder)
        if (const auto ladder = at("MakeProgressiveSettings.ladder", core::checkSettings(*settings.ladder));
            !ladder)
            return ladder;
    return at("MakeProgressiveSettings.arrangement", core::checkSettings(settings.arrangement));
}

foundation::Result<ProgressiveModel> makeProgressive(osg::Node& node, const std::string& name,
                                                     const MakeProgressiveSettings& settings)
{
    if (const auto checked = checkSettings(settings); !checked) return checked.error();
    auto imported = importNode(node, name);
    if (!imported) return imported.error();
    core::Mesh& mesh = imported->mesh;
    core::makeSimplifiable(mesh);
    if (mesh.faces.empty())
        return foundation::Error{name, "has no triangles that can be simplified",
                                 "give a model with surfaces"};
    core::SimplifySettings simplifySettings = settings.simplify;
    simplifySettings.placement = core::Placement::subset;
    if (simplifySettings.materialColours.empty())
        simplifySettings.materialColours = materialColours(mesh, imported->states);
    const core::CollapseSequence sequence = core::simplify(mesh, simplifySettings);
    core::ProgressiveMesh progressive = core::buildProgressiveMesh(mesh, sequence, settings.arrangement);
    if (settings.ladder) core::measureLevels(progressive, *settings.ladder);
    const osg::ref_ptr<ProgressiveShape> shape =
        new ProgressiveShape(std::move(progressive), imported->states);

    ProgressiveModel model{new ProgressiveNode(shape), imported->report};
    model.node->setName(node.getName());
    if (imported->remainder->getNumChildren() > 0) model.node->addChild(imported->remainder);
    return model;
}

osg::ref_ptr<osg::Group> bakeLevel(const ProgressiveShape& shape, std::uint32_t steps)
{
    return exportNode(core::meshAfter(shape.progressive(), steps), shape.states());
}

} // namespace osgPMObjects
