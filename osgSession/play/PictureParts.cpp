// SPDX-License-Identifier: Apache-2.0
#include "PictureParts.h"

#include <chrono>

#include <osg/GL>
#include <osg/NodeVisitor>

#include <osgRoads/RoadDrawable>

#include "measurement/ProcessorTime.h"

namespace trainer
{

namespace
{

/// Shows or hides what is drawn of roads and of the things on them.
class RoadSwitch : public osg::NodeVisitor
{
public:
    explicit RoadSwitch(bool isShown) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), _isShown(isShown)
    {
        setNodeMaskOverride(~0U);
    }

    void apply(osg::Drawable& drawable) override
    {
        if (dynamic_cast<osgRoads::RoadDrawable*>(&drawable)) drawable.setNodeMask(_isShown ? ~0U : 0U);
    }

private:
    bool _isShown;
};

void setShown(osg::Node* node, bool isShown)
{
    if (node) node->setNodeMask(isShown ? ~0U : 0U);
}

} // namespace

PictureParts::PictureParts(PlayScene& scene, InteriorView* interior, osgViewer::Viewer& viewer,
                           const std::vector<osg::ref_ptr<osg::GraphicsContext>>& contexts)
    : _viewer(viewer), _contexts(contexts)
{
    addParts(scene);
    if (interior) addParts(*interior);
    for (unsigned int i = 0; i < viewer.getNumSlaves(); ++i)
    {
        _counters.push_back(new DrawCounter);
        viewer.getSlave(i)._camera->setCullCallback(_counters.back());
    }
    for (const Part& part : _parts)
        _costs.push_back({part.name, {}});
}

void PictureParts::addParts(PlayScene& scene)
{
    ScenarioScene* const drawn = scene.scene.get();
    _parts.push_back({"", [](bool) {}});
    if (drawn->sunlit().isShown())
        _parts.push_back({"shadows", [drawn](bool isShown) { drawn->setShadows(isShown); }});
    _parts.push_back({"clouds", [drawn](bool isShown) { drawn->showClouds(isShown); }});
    if (scene.scenery)
        _parts.push_back(
            {"scenery", [root = scene.scenery->node.root](bool isShown) { setShown(root, isShown); }});
    for (const StandingPart& part : scene.terrain.standing)
        _parts.push_back({part.name, [node = part.node](bool isShown) { setShown(node, isShown); }});
    _parts.push_back({"entities", [drawn](bool isShown)
                      {
                          if (!isShown) drawn->hideEntities();
                      }});
    if (scene.cover)
        _parts.push_back({"ground cover", [node = scene.cover->node()](bool isShown)
                          { node->setNodeMask(isShown ? osgSky::SunShadows::kCastsNone : 0U); }});
    if (scene.skyShade)
        _parts.push_back(
            {"sky shade", [shade = scene.skyShade.get()](bool isShown) { shade->setShown(isShown); }});
    if (scene.terrain.roads)
        _parts.push_back({"roads",
                          [node = scene.terrain.node, things = scene.terrain.roadThings](bool isShown)
                          {
                              RoadSwitch roads(isShown);
                              node->accept(roads);
                              if (things) setShown(things->node(), isShown);
                          }});
    if (scene.terrain.terrain)
        _parts.push_back(
            {"ground", [terrain = scene.terrain.terrain](bool isShown) { setShown(terrain, isShown); }});
    for (unsigned int i = 0; i < drawn->root().getNumChildren(); ++i)
        if (osg::Node* const node = drawn->root().getChild(i); node->getName() == "sky")
            _parts.push_back({"sky", [node](bool isShown) { setShown(node, isShown); }});
}

/// Mirrors and inside are told anew in every picture what they show.
void PictureParts::addParts(InteriorView& interior)
{
    _parts.push_back({"mirrors", [&interior](bool isShown)
                      {
                          if (!isShown) interior.restMirrors();
                      }});
    _parts.push_back({"inside without mirrors", [&interior](bool isShown) { interior.showInside(isShown); }});
}

void PictureParts::draw(double timeS)
{
    const std::size_t run = _pictures / kRun, turn = run == 0 ? 0 : (run - 1) % _parts.size();
    _parts[turn].show(false);
    PictureCost cost;
    const auto begin = std::chrono::steady_clock::now();
    const double usedMs = measurement::processorMs();
    _viewer.frame(timeS);
    for (const auto& context : _contexts)
    {
        context->makeCurrent();
        glFinish();
    }
    cost.processorMs = measurement::processorMs() - usedMs;
    cost.wallMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    for (const auto& counter : _counters)
    {
        cost.draws += counter->draws();
        cost.mapDraws += counter->drawsBefore();
    }
    _parts[turn].show(true);
    if (run > 0 && _pictures % kRun > 0) _costs[turn].pictures.push_back(cost);
    ++_pictures;
}

} // namespace trainer
