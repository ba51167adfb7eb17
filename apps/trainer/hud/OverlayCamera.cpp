// SPDX-License-Identifier: Apache-2.0
#include "hud/OverlayCamera.h"

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geometry>

namespace trainer
{

namespace
{

constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono-Bold.ttf";

/// The monospaced font of the package fonts-dejavu-core, or OSG's own where it is not installed.
osg::ref_ptr<osgText::Font> overlayFont()
{
    static const osg::ref_ptr<osgText::Font> kFont = osgText::readRefFontFile(kFontFile);
    return kFont ? kFont : osgText::Font::getDefaultFont();
}

} // namespace

osg::ref_ptr<osg::Camera> makeOverlayCamera(int order)
{
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setViewMatrix(osg::Matrixd::identity());
    camera->setRenderOrder(osg::Camera::POST_RENDER, order);
    camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setProjectionResizePolicy(osg::Camera::FIXED);
    camera->setAllowEventFocus(false);
    osg::StateSet& state = *camera->getOrCreateStateSet();
    state.setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    state.setMode(GL_BLEND, osg::StateAttribute::ON);
    state.setAttribute(new osg::BlendFunc);
    state.setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
    return camera;
}

void fitOverlay(osg::Camera& camera, int widthPx, int heightPx)
{
    camera.setViewport(0, 0, widthPx, heightPx);
    camera.setProjectionMatrixAsOrtho2D(0.0, widthPx, 0.0, heightPx);
}

osg::ref_ptr<osgText::Text> makeOverlayText(osgText::Text::AlignmentType alignment)
{
    osg::ref_ptr<osgText::Text> text = new osgText::Text;
    text->setFont(overlayFont());
    text->setDataVariance(osg::Object::DYNAMIC);
    text->setCharacterSizeMode(osgText::Text::OBJECT_COORDS);
    text->setAxisAlignment(osgText::Text::XY_PLANE);
    text->setAlignment(alignment);
    text->setColor({1.0F, 1.0F, 1.0F, 1.0F});
    text->setBackdropType(osgText::Text::OUTLINE);
    text->setBackdropColor({0.0F, 0.0F, 0.0F, 0.9F});
    text->setCullingActive(false);
    return text;
}

osg::ref_ptr<osg::Geometry> makeUnitPanel(const osg::Vec4& colour)
{
    osg::ref_ptr<osg::Geometry> panel = new osg::Geometry;
    const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const auto& corner :
         {osg::Vec3(0, 0, 0), osg::Vec3(1, 0, 0), osg::Vec3(1, 1, 0), osg::Vec3(0, 1, 0)})
        corners->push_back(corner);
    panel->setVertexArray(corners);
    const osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array(osg::Array::BIND_OVERALL);
    colours->push_back(colour);
    panel->setColorArray(colours);
    panel->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 4));
    panel->setUseVertexBufferObjects(true);
    panel->setCullingActive(false);
    return panel;
}

} // namespace trainer
