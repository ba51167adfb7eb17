// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/ProgressiveNode>

#include "AddSerializers.h"
#include "SerializeShared.h"
#include "SettingsFields.h"

namespace osgPMObjects
{

/// A ProgressiveNode in a scene file: its shape, its settings, and the children beside its drawable. The
/// drawable belongs to views and is made again, so the node is written as a Node, not as a Group with all of
/// its children.
struct NodeSerializer
{
    static bool hasShape(const ProgressiveNode& node) { return node.shape() != nullptr; }
    static bool writeShape(osgDB::OutputStream& out, const ProgressiveNode& node)
    {
        osgPMObjects::writeShape(out, *node.shape());
        return true;
    }
    static bool readShape(osgDB::InputStream& in, ProgressiveNode& node)
    {
        const osg::ref_ptr<ProgressiveShape> shape = osgPMObjects::readShape(in, "ProgressiveNode");
        if (!shape) return false;
        node.setDrawable(new ProgressiveDrawable(shape));
        node.addChild(node._drawnChild);
        return true;
    }

    static bool writeSettings(osgDB::OutputStream& out, const ProgressiveNode& node)
    {
        osgTraversal::writeLines(out, osgTraversal::linesOf(node.settings()));
        return true;
    }
    static bool readSettings(osgDB::InputStream& in, ProgressiveNode& node)
    {
        return osgTraversal::readSettings<ProgressiveNodeSettings>(
            in, [&](const ProgressiveNodeSettings& settings) { return node.setSettings(settings); });
    }

    static unsigned int otherChildren(const ProgressiveNode& node)
    {
        return node.getNumChildren() - (hasShape(node) ? 1u : 0u);
    }
    static bool hasOthers(const ProgressiveNode& node) { return otherChildren(node) > 0; }
    static bool writeOthers(osgDB::OutputStream& out, const ProgressiveNode& node)
    {
        out.writeSize(otherChildren(node));
        out << out.BEGIN_BRACKET << std::endl;
        for (unsigned int i = 0; i < node.getNumChildren(); ++i)
            if (node.getChild(i) != node._drawnChild) out << node.getChild(i);
        out << out.END_BRACKET << std::endl;
        return true;
    }
    static bool readOthers(osgDB::InputStream& in, ProgressiveNode& node)
    {
        const std::size_t count = in.readSize();
        in >> in.BEGIN_BRACKET;
        for (std::size_t i = 0; i < count && !in.getException(); ++i)
        {
            const osg::ref_ptr<osg::Node> other = in.readObjectOfType<osg::Node>();
            if (other) node.addChild(other);
        }
        in >> in.END_BRACKET;
        return in.getException() == nullptr;
    }
};

void addNodeSerializer()
{
    using S = NodeSerializer;
    osgTraversal::addClass<ProgressiveNode>(
        "osgPMObjects::ProgressiveNode", "osg::Object osg::Node osgPMObjects::ProgressiveNode",
        {{"Shape", &S::hasShape, &S::readShape, &S::writeShape},
         {"Settings", &osgTraversal::isAlwaysThere<ProgressiveNode>, &S::readSettings, &S::writeSettings},
         {"OtherChildren", &S::hasOthers, &S::readOthers, &S::writeOthers}});
}

} // namespace osgPMObjects
