// SPDX-License-Identifier: Apache-2.0
#include <map>

#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include <osgPMObjects/MissingImages>

namespace osgPMObjects
{

/// Stands in for the registry's callback, and calls that one where there is one.
class MissingImages::Callback : public osgDB::ReadFileCallback
{
public:
    explicit Callback(osgDB::ReadFileCallback* previous) : before(previous) {}

    osgDB::ReaderWriter::ReadResult readImage(const std::string& name, const osgDB::Options* options) override
    {
        osgDB::ReaderWriter::ReadResult read =
            before ? before->readImage(name, options)
                   : osgDB::Registry::instance()->readImageImplementation(name, options);
        // A loader may try several folders for one file.
        const std::string file = osgDB::getSimpleFileName(name);
        if (read.validImage())
            found[file] = name;
        else
            missed.try_emplace(file, name);
        return read;
    }

    osg::ref_ptr<osgDB::ReadFileCallback> before;
    std::map<std::string, std::string> found, missed; ///< by simple file name: as the model names it
};

MissingImages::MissingImages() : _callback(new Callback(osgDB::Registry::instance()->getReadFileCallback()))
{
    osgDB::Registry::instance()->setReadFileCallback(_callback);
}

MissingImages::~MissingImages()
{
    osgDB::Registry::instance()->setReadFileCallback(_callback->before);
}

std::vector<std::string> MissingImages::names() const
{
    std::vector<std::string> names;
    for (const auto& [file, name] : _callback->missed)
        if (!_callback->found.contains(file)) names.push_back(name);
    return names;
}

} // namespace osgPMObjects
