// SPDX-License-Identifier: Apache-2.0
#include "Contestants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <osg/LOD>
#include <osg/MatrixTransform>

#include <osgPMObjects/core/order/FaceOrder.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/selection/AreaRows.h>

#include <osgPMObjects/ExportNode>

namespace fieldbench
{

using namespace osgPMObjects;

namespace
{

constexpr std::array<double, 5> kShares{1.0, 0.4, 0.16, 0.06, 0.02};
constexpr std::uint32_t kLeastFaces = 24; // with fewer, a tree has lost its shape

osg::ref_ptr<osg::Group> levelOf(const ProgressiveShape& shape, std::uint32_t steps)
{
    core::Mesh mesh = core::meshAfter(shape.progressive(), steps);
    core::orderFaces(mesh, core::FaceOrder::library);
    return exportNode(mesh, shape.states());
}

std::uint32_t stepsOfShare(const core::LevelTable& levels, double share)
{
    const double faces = share * levels.faces.front();
    const auto level = std::partition_point(levels.faces.begin(), levels.faces.end(),
                                            [=](std::uint32_t f) { return f > faces; });
    return std::min(levels.mostSteps(), static_cast<std::uint32_t>(level - levels.faces.begin()));
}

osg::ref_ptr<osg::Node> lodOf(const ProgressiveShape& shape, double trianglePx, double pixelsPerTangent)
{
    const core::LevelTable& levels = shape.levels();
    const osg::ref_ptr<osg::LOD> lod = new osg::LOD;
    lod->setCenterMode(osg::LOD::USER_DEFINED_CENTER);
    const glm::dvec3& centre = shape.sphere().centre;
    lod->setCenter(osg::Vec3d(centre.x, centre.y, centre.z) + shape.origin());
    lod->setRadius(shape.sphere().radius);
    double from = 0.0;
    for (std::size_t i = 0; i < kShares.size(); ++i)
    {
        // A level ends where the sphere covers half of the pixels that its faces are to cover, as in
        // AreaRows::halving().
        const double leastPx = 0.5 * kShares[i] * levels.faces.front() * trianglePx;
        const double to = pixelsPerTangent * shape.sphere().radius * std::sqrt(std::numbers::pi / leastPx);
        const bool isLast = i + 1 == kShares.size();
        lod->addChild(levelOf(shape, stepsOfShare(levels, kShares[i])), static_cast<float>(from),
                      isLast ? std::numeric_limits<float>::max() : static_cast<float>(to));
        from = to;
    }
    return lod;
}

osg::ref_ptr<osg::Node> placed(const std::vector<osg::ref_ptr<osg::Node>>& models,
                               const std::vector<FieldInstance>& instances)
{
    // Groups of 50 neighbours, so that OSG can cull many instances at once.
    constexpr std::size_t kPerGroup = 50;
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    for (std::size_t i = 0; i < instances.size(); ++i)
    {
        if (i % kPerGroup == 0) root->addChild(new osg::Group);
        const FieldInstance& instance = instances[i];
        const double s = instance.scale;
        const osg::ref_ptr<osg::MatrixTransform> transform =
            new osg::MatrixTransform(osg::Matrixd::scale(s, s, s) * osg::Matrixd::rotate(instance.attitude) *
                                     osg::Matrixd::translate(instance.position));
        transform->setDataVariance(osg::Object::STATIC);
        transform->addChild(models[instance.kind]);
        root->getChild(root->getNumChildren() - 1)->asGroup()->addChild(transform);
    }
    return root;
}

} // namespace

osg::ref_ptr<osg::Node> progressiveField(const Shapes& shapes, const std::vector<FieldInstance>& instances,
                                         double trianglePx)
{
    const osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    std::vector<FieldKind> kinds;
    for (const auto& shape : shapes)
    {
        kinds.push_back({shape, {}});
        core::SelectionSettings& selection = kinds.back().selection;
        selection.method = core::SelectionMethod::sphereArea;
        selection.areaRows = core::AreaRows::halving(shape->levels(), trianglePx, kLeastFaces);
    }
    if (!field->setContents(kinds, instances)) return nullptr;
    return field;
}

osg::ref_ptr<osg::Node> discreteLods(const Shapes& shapes, const std::vector<FieldInstance>& instances,
                                     double trianglePx, double pixelsPerTangent)
{
    std::vector<osg::ref_ptr<osg::Node>> models;
    for (const auto& shape : shapes)
        models.push_back(lodOf(*shape, trianglePx, pixelsPerTangent));
    return placed(models, instances);
}

osg::ref_ptr<osg::Node> fullDetail(const Shapes& shapes, const std::vector<FieldInstance>& instances)
{
    std::vector<osg::ref_ptr<osg::Node>> models;
    for (const auto& shape : shapes)
        models.push_back(levelOf(*shape, 0));
    return placed(models, instances);
}

} // namespace fieldbench
