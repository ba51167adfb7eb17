// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/NodeVisitor>

#include <osgPMObjects/core/mesh/MeshBuilder.h>

#include <osgPMObjects/ImportNode>

#include "StateTable.h"

namespace osgPMObjects
{

/// Traverses a graph as importNode() describes and adds its surfaces to a mesh.
/// Invariant: one matrix and one state for each node of the path, and one below them.
class SurfaceVisitor : public osg::NodeVisitor
{
public:
    SurfaceVisitor();

    void apply(osg::Node& node) override;
    void apply(osg::Transform& transform) override;
    void apply(osg::Camera& node) override;
    void apply(osg::AutoTransform& node) override;
    void apply(osg::Billboard& node) override;
    void apply(osg::Projection& node) override;
    void apply(osg::LightSource& node) override;
    void apply(osg::ClipNode& node) override;
    void apply(osg::TexGenNode& node) override;
    void apply(osg::LOD& lod) override;
    void apply(osg::PagedLOD& lod) override;
    void apply(osg::ProxyNode& node) override;
    void apply(osg::Switch& node) override;
    void apply(osg::Sequence& node) override;
    void apply(osg::Drawable& drawable) override;
    void apply(osg::Geometry& geometry) override;

    ImportedModel finish();
    const core::Mesh& mesh() const { return _mesh.mesh(); }
    bool isTooDeep() const { return _isTooDeep; }

    static constexpr std::size_t kDeepest =
        1000; ///< nodes of a path; a graph that contains itself has no end

private:
    /// Calls `inside` with the node's state and the matrix applied, unless the node is hidden or too deep.
    template<class Inside>
    void enter(osg::Node& node, const osg::Matrixd& localToRoot, const Inside& inside);
    /// Keeps a node unchanged, under the state and matrix above it.
    void keep(osg::Node& node, std::size_t& counter);
    void read(const osg::Geometry& geometry);
    /// Keeps the primitives of a geometry that are not surfaces.
    void keepOthers(const osg::Geometry& geometry);
    std::string partName(const osg::Drawable& drawable) const;

    core::MeshBuilder _mesh;
    StateTable _states;
    ImportReport _report;
    osg::ref_ptr<osg::Group> _remainder = new osg::Group;
    std::vector<osg::Matrixd> _matrices;
    std::vector<osg::ref_ptr<osg::StateSet>> _path;
    bool _isTooDeep = false;
};

} // namespace osgPMObjects
