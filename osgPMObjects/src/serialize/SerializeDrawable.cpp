// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/ProgressiveDrawable>

#include "AddSerializers.h"
#include "SerializeShared.h"

namespace osgPMObjects
{

/// A ProgressiveDrawable that stands alone, without a ProgressiveNode, in a scene file: its shape and its
/// steps.
struct DrawableSerializer
{
    static bool hasShape(const ProgressiveDrawable& drawable) { return drawable.shape() != nullptr; }
    static bool writeShape(osgDB::OutputStream& out, const ProgressiveDrawable& drawable)
    {
        osgPMObjects::writeShape(out, *drawable.shape());
        return true;
    }
    static bool readShape(osgDB::InputStream& in, ProgressiveDrawable& drawable)
    {
        const osg::ref_ptr<ProgressiveShape> shape = osgPMObjects::readShape(in, "ProgressiveDrawable");
        if (shape) drawable.setProgressiveShape(shape);
        return shape != nullptr;
    }

    static bool hasSteps(const ProgressiveDrawable& drawable) { return drawable.steps() > 0; }
    static bool writeSteps(osgDB::OutputStream& out, const ProgressiveDrawable& drawable)
    {
        out << drawable.steps() << std::endl;
        return true;
    }
    static bool readSteps(osgDB::InputStream& in, ProgressiveDrawable& drawable)
    {
        unsigned int steps = 0;
        in >> steps;
        return !in.getException() && osgTraversal::passOn(in, drawable.setSteps(steps));
    }
};

void addDrawableSerializer()
{
    using S = DrawableSerializer;
    osgTraversal::addClass<ProgressiveDrawable>(
        "osgPMObjects::ProgressiveDrawable",
        "osg::Object osg::Node osg::Drawable osgPMObjects::ProgressiveDrawable",
        {{"ProgressiveShape", &S::hasShape, &S::readShape, &S::writeShape},
         {"Steps", &S::hasSteps, &S::readSteps, &S::writeSteps}});
}

} // namespace osgPMObjects
