// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>

#include <foundation/Result.h>

#include <osgDB/ObjectWrapper>

#include <osgPMObjects/ProgressiveShape>

namespace osgPMObjects
{

/// Writes a shape as an object of the scene file, which has it once, whoever shares it.
void writeShape(osgDB::OutputStream& out, const ProgressiveShape& shape);

/// Reads a shape. Errors: there is none, or it has no levels; then the stream has an exception that names `owner`.
osg::ref_ptr<ProgressiveShape> readShape(osgDB::InputStream& in, const char* owner);

/// Gives the stream the exception of an outcome that failed. Returns whether it succeeded.
bool passOn(osgDB::InputStream& in, const foundation::Outcome& outcome);

/// One property of a class in scene files.
template<class Class>
struct Property
{
    const char* name;
    bool (*isThere)(const Class&);
    bool (*read)(osgDB::InputStream&, Class&);
    bool (*write)(osgDB::OutputStream&, const Class&);
};

/// Registers a class with its properties, unless a program or a plugin already has: it would be the same code.
/// `associates`: the base classes whose properties the file has, and the class, in OSG's form.
template<class Class>
void addClass(osgDB::ObjectWrapperManager& manager, const std::string& name, const std::string& associates,
              std::initializer_list<Property<Class>> properties)
{
    if (manager.getWrapperMap().count(name) > 0) return;
    const auto make = +[]() -> osg::Object* { return new Class; };
    const osg::ref_ptr<osgDB::ObjectWrapper> wrapper = new osgDB::ObjectWrapper(make, name, associates);
    for (const Property<Class>& p : properties)
        wrapper->addSerializer(new osgDB::UserSerializer<Class>(p.name, p.isThere, p.read, p.write),
                               osgDB::BaseSerializer::RW_USER);
    manager.addWrapper(wrapper);
}

} // namespace osgPMObjects
