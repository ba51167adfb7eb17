// SPDX-License-Identifier: Apache-2.0
#include "SurfaceVisitor.h"

#include <algorithm>

#include <osg/AutoTransform>
#include <osg/Billboard>
#include <osg/Camera>
#include <osg/ClipNode>
#include <osg/LightSource>
#include <osg/MatrixTransform>
#include <osg/PagedLOD>
#include <osg/Projection>
#include <osg/ProxyNode>
#include <osg/Sequence>
#include <osg/Switch>
#include <osg/TexGenNode>

#include "GeometryReader.h"
#include "Triangles.h"

namespace osgPMObjects
{

namespace
{

/// Returns the finest child of an LOD: the one that is drawn nearest to the eye, or largest on the screen.
unsigned finestChild(const osg::LOD& lod)
{
    const auto& ranges = lod.getRangeList();
    const bool bySize = lod.getRangeMode() == osg::LOD::PIXEL_SIZE_ON_SCREEN;
    unsigned best = 0;
    for (unsigned i = 1; i < std::min<std::size_t>(lod.getNumChildren(), ranges.size()); ++i)
        if (bySize ? ranges[i].second > ranges[best].second : ranges[i].first < ranges[best].first) best = i;
    return best;
}

bool isSurfaceOf(const osg::Geometry& geometry, unsigned set)
{
    const osg::PrimitiveSet* primitives = geometry.getPrimitiveSet(set);
    return primitives && isSurface(primitives->getMode());
}

} // namespace

SurfaceVisitor::SurfaceVisitor()
    : NodeVisitor(TRAVERSE_ACTIVE_CHILDREN), _matrices{osg::Matrixd::identity()}, _path{nullptr}
{
    setNodeMaskOverride(~0u); // so that hidden nodes are visited and counted
}

template<class Inside>
void SurfaceVisitor::enter(osg::Node& node, const osg::Matrixd& localToRoot, const Inside& inside)
{
    if (node.getNodeMask() == 0)
    {
        ++_report.hiddenChildren;
        return;
    }
    _isTooDeep = _isTooDeep || _path.size() > kDeepest;
    if (_isTooDeep) return;
    if (node.getUpdateCallback() || node.getEventCallback()) ++_report.bakedAnimations;
    _path.push_back(_states.below(_path.back(), node.getStateSet()));
    _matrices.push_back(localToRoot);
    inside();
    _matrices.pop_back();
    _path.pop_back();
}

void SurfaceVisitor::apply(osg::Node& node)
{
    enter(node, osg::Matrixd(_matrices.back()), [&] { traverse(node); });
}

void SurfaceVisitor::apply(osg::Transform& transform)
{
    osg::Matrixd matrix = _matrices.back();
    transform.computeLocalToWorldMatrix(matrix, this);
    enter(transform, matrix, [&] { traverse(transform); });
}

void SurfaceVisitor::apply(osg::Camera& node)
{
    keep(node, _report.keptNodes);
}
void SurfaceVisitor::apply(osg::AutoTransform& node)
{
    keep(node, _report.keptNodes);
}
void SurfaceVisitor::apply(osg::Billboard& node)
{
    keep(node, _report.keptNodes);
}
void SurfaceVisitor::apply(osg::Projection& node)
{
    keep(node, _report.keptNodes);
}
void SurfaceVisitor::apply(osg::LightSource& node)
{
    keep(node, _report.keptNodes);
}
void SurfaceVisitor::apply(osg::ClipNode& node)
{
    keep(node, _report.keptNodes);
}
void SurfaceVisitor::apply(osg::TexGenNode& node)
{
    keep(node, _report.keptNodes);
}

void SurfaceVisitor::apply(osg::LOD& lod)
{
    if (lod.getNumChildren() == 0) return;
    _report.coarserLevels += lod.getNumChildren() - 1;
    enter(lod, osg::Matrixd(_matrices.back()), [&] { lod.getChild(finestChild(lod))->accept(*this); });
}

void SurfaceVisitor::apply(osg::PagedLOD& lod)
{
    _report.unloadedChildren += std::max(lod.getNumFileNames(), lod.getNumChildren()) - lod.getNumChildren();
    apply(static_cast<osg::LOD&>(lod));
}

void SurfaceVisitor::apply(osg::ProxyNode& node)
{
    _report.unloadedChildren +=
        std::max(node.getNumFileNames(), node.getNumChildren()) - node.getNumChildren();
    apply(static_cast<osg::Node&>(node));
}

void SurfaceVisitor::apply(osg::Switch& node)
{
    const auto& values = node.getValueList();
    _report.hiddenChildren += static_cast<std::size_t>(std::count(values.begin(), values.end(), false));
    apply(static_cast<osg::Node&>(node));
}

void SurfaceVisitor::apply(osg::Sequence& node)
{
    if (node.getNumChildren() == 0) return;
    _report.hiddenChildren += node.getNumChildren() - 1;
    enter(node, osg::Matrixd(_matrices.back()), [&] { node.getChild(0)->accept(*this); });
}

void SurfaceVisitor::apply(osg::Drawable& drawable)
{
    keep(drawable, _report.keptDrawables);
}

void SurfaceVisitor::apply(osg::Geometry& geometry)
{
    if (geometry.getNodeMask() == 0)
    {
        ++_report.hiddenChildren;
        return;
    }
    if (!geometry.containsDeprecatedData()) return read(geometry);
    const osg::ref_ptr<osg::Geometry> fixed = new osg::Geometry(
        geometry, osg::CopyOp(osg::CopyOp::DEEP_COPY_ARRAYS | osg::CopyOp::DEEP_COPY_PRIMITIVES));
    fixed->fixDeprecatedData();
    read(*fixed);
}

void SurfaceVisitor::read(const osg::Geometry& geometry)
{
    bool hasSurface = false, hasOthers = false;
    for (unsigned i = 0; i < geometry.getNumPrimitiveSets(); ++i)
        (isSurfaceOf(geometry, i) ? hasSurface : hasOthers) = true;
    if (hasOthers) keepOthers(geometry);
    if (!hasSurface) return;
    auto* ownState = const_cast<osg::StateSet*>(geometry.getStateSet()); // shared, not changed
    const osg::ref_ptr<osg::StateSet> state = _states.below(_path.back(), ownState);
    const std::uint32_t material = _mesh.material(_states.materialOf(state, attributesOf(geometry)));
    readGeometry(geometry, {_matrices.back(), material, _mesh.part(partName(geometry))}, _mesh, _report);
}

void SurfaceVisitor::keepOthers(const osg::Geometry& geometry)
{
    const osg::ref_ptr<osg::Geometry> others = new osg::Geometry(geometry, osg::CopyOp::SHALLOW_COPY);
    for (unsigned i = 0; i < others->getNumPrimitiveSets();
         ++i) // emptied, not removed: arrays may be bound by set
        if (isSurfaceOf(geometry, i)) others->setPrimitiveSet(i, new osg::DrawArrays(GL_POINTS, 0, 0));
    keep(*others, _report.keptDrawables);
}

void SurfaceVisitor::keep(osg::Node& node, std::size_t& counter)
{
    if (node.getNodeMask() == 0)
    {
        ++_report.hiddenChildren;
        return;
    }
    ++counter;
    const osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(_matrices.back());
    if (_path.back()) place->setStateSet(_path.back());
    place->addChild(&node);
    _remainder->addChild(place);
}

/// Returns the name of the drawable, or of the nearest node above it that has one.
std::string SurfaceVisitor::partName(const osg::Drawable& drawable) const
{
    if (!drawable.getName().empty()) return drawable.getName();
    const osg::NodePath& path = getNodePath();
    const auto named =
        std::find_if(path.rbegin(), path.rend(), [](const osg::Node* n) { return !n->getName().empty(); });
    return named == path.rend() ? std::string() : (*named)->getName();
}

ImportedModel SurfaceVisitor::finish()
{
    return {_mesh.finish(), _states.states(), _remainder, _report};
}

} // namespace osgPMObjects
