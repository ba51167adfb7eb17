// SPDX-License-Identifier: Apache-2.0
#include <osg/PagedLOD>
#include <osg/ProxyNode>
#include <osgDB/Options>
#include <osgDB/Registry>
#include <osgTerrain/Terrain>
#include <osgTerrain/TerrainTile>

#include <osgTerrainROAM/RoamTechnique>

namespace osgTerrainROAM
{

namespace
{

/// Reads the files of a paged node and installs the technique on them, in the reading thread.
class InstallingReader : public osgDB::ReadFileCallback
{
public:
    InstallingReader(const RoamTechnique& prototype, osgDB::ReadFileCallback* inner)
        : _prototype(&prototype), _inner(inner)
    {
    }

    osgDB::ReaderWriter::ReadResult readNode(const std::string& name, const osgDB::Options* options) override
    {
        // Nodes that are read below find this reader in the options they are read with.
        osgDB::ReaderWriter::ReadResult result =
            _inner ? _inner->readNode(name, options) : osgDB::ReadFileCallback::readNode(name, options);
        if (osg::Node* node = result.getNode()) installTechnique(*node, *_prototype);
        return result;
    }

    bool isOf(const RoamTechnique& prototype) const { return _prototype == &prototype; }

protected:
    ~InstallingReader() override = default;

private:
    osg::ref_ptr<const RoamTechnique> _prototype;
    osg::ref_ptr<osgDB::ReadFileCallback> _inner;
};

/// The options of a paged node with our reader before theirs.
osg::ref_ptr<osgDB::Options> installedOptions(const osg::Referenced* present, const RoamTechnique& prototype)
{
    const auto* options = dynamic_cast<const osgDB::Options*>(present);
    if (!options) options = osgDB::Registry::instance()->getOptions();
    osgDB::ReadFileCallback* const inner = options ? options->getReadFileCallback() : nullptr;
    const auto* ours = dynamic_cast<const InstallingReader*>(inner);
    osg::ref_ptr<osgDB::Options> installed =
        options ? static_cast<osgDB::Options*>(options->clone(osg::CopyOp::SHALLOW_COPY))
                : new osgDB::Options;
    osgDB::ReadFileCallback* const before =
        inner ? inner : osgDB::Registry::instance()->getReadFileCallback();
    if (!ours || !ours->isOf(prototype))
        installed->setReadFileCallback(new InstallingReader(prototype, before));
    return installed;
}

class Installer : public osg::NodeVisitor
{
public:
    explicit Installer(const RoamTechnique& prototype)
        : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), _prototype(prototype)
    {
        setNodeMaskOverride(~0u);
    }

    void apply(osg::Group& group) override
    {
        if (auto* tile = dynamic_cast<osgTerrain::TerrainTile*>(&group)) return install(*tile);
        traverse(group);
    }

    void apply(osg::CoordinateSystemNode& node) override
    {
        if (auto* terrain = dynamic_cast<osgTerrain::Terrain*>(&node))
            terrain->setTerrainTechniquePrototype(copy());
        traverse(node);
    }

    void apply(osg::PagedLOD& node) override
    {
        node.setDatabaseOptions(installedOptions(node.getDatabaseOptions(), _prototype));
        for (unsigned int i = 0; i < node.getNumFileNames(); ++i)
            count.pagedFiles += node.getFileName(i).empty() ? 0 : 1;
        traverse(node);
    }

    void apply(osg::ProxyNode& node) override
    {
        node.setDatabaseOptions(installedOptions(node.getDatabaseOptions(), _prototype));
        if (node.getNumChildren() < node.getNumFileNames())
            count.pagedFiles += node.getNumFileNames() - node.getNumChildren();
        traverse(node);
    }

    TechniqueCount count;

private:
    RoamTechnique* copy() const
    {
        return static_cast<RoamTechnique*>(_prototype.clone(osg::CopyOp::SHALLOW_COPY));
    }

    /// Traverses the tile as a group: its own traverse() would build the technique's nodes.
    void install(osgTerrain::TerrainTile& tile)
    {
        tile.setTerrainTechnique(copy());
        ++count.tiles;
        tile.osg::Group::traverse(*this);
    }

    const RoamTechnique& _prototype;
};

} // namespace

TechniqueCount installTechnique(osg::Node& database, const RoamTechnique& prototype)
{
    Installer installer(prototype);
    database.accept(installer);
    return installer.count;
}

} // namespace osgTerrainROAM
