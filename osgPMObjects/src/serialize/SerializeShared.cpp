// SPDX-License-Identifier: Apache-2.0
#include "SerializeShared.h"

namespace osgPMObjects
{

void writeShape(osgDB::OutputStream& out, const ProgressiveShape& shape)
{
    out << out.BEGIN_BRACKET << std::endl << &shape << out.END_BRACKET << std::endl;
}

osg::ref_ptr<ProgressiveShape> readShape(osgDB::InputStream& in, const char* owner)
{
    in >> in.BEGIN_BRACKET;
    const osg::ref_ptr<ProgressiveShape> shape = in.readObjectOfType<ProgressiveShape>();
    if (in.getException()) return nullptr;
    if (!shape || shape->groups().empty())
    {
        in.throwException(std::string(owner) +
                          ": its shape is missing or has no levels; write the scene again");
        return nullptr;
    }
    in >> in.END_BRACKET;
    return shape;
}

} // namespace osgPMObjects
