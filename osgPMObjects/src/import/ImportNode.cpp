// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/mesh/MeshCheck.h>

#include <osgPMObjects/ImportNode>

#include "SurfaceVisitor.h"

namespace osgPMObjects
{

foundation::Result<ImportedModel> importNode(osg::Node& node, const std::string& file)
{
    SurfaceVisitor visitor;
    node.accept(visitor);
    if (visitor.isTooDeep())
        return foundation::Error{file,
                                 "nodes are nested deeper than " + std::to_string(SurfaceVisitor::kDeepest),
                                 "look for a group that contains itself, or flatten the graph"};
    ImportedModel model = visitor.finish();
    if (const std::string defect = core::defectOf(model.mesh); !defect.empty())
        return foundation::Error{file, defect, "repair the model, or split it"};
    return model;
}

} // namespace osgPMObjects
