// SPDX-License-Identifier: Apache-2.0
// Uses a progressive object in another program, and osgTraversal, which that program's own drawables may
// need.
#include <cstdio>

#include <osg/Geode>
#include <osg/ShapeDrawable>

#include <osgPMObjects/MakeProgressive>
#include <osgTraversal/ContextBuffer>
#include <osgTraversal/CullFacts>

int main()
{
    const osg::ref_ptr<osg::Geode> ball = new osg::Geode;
    ball->addDrawable(new osg::ShapeDrawable(new osg::Sphere(osg::Vec3(), 1.0F)));
    const auto model = osgPMObjects::makeProgressive(*ball, "ball");
    if (!model)
    {
        std::printf("%s\n", model.error().message().c_str());
        return 1;
    }
    const std::uint32_t steps = model->node->shape()->progressive().stepCount;
    const double scale = osgTraversal::eyePerLocal(osg::Matrixd::scale(2.0, 2.0, 2.0));
    const osgTraversal::ContextBuffer buffer(0);
    std::printf("%u steps, scale %g\n", steps, scale);
    return steps > 100 && scale == 2.0 && !buffer.isMade() ? 0 : 1;
}
