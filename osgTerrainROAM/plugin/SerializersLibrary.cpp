// SPDX-License-Identifier: Apache-2.0
// OpenSceneGraph loads this library when a scene file names a class of the namespace osgTerrainROAM that is
// not registered.
#include <osgTerrainROAM/Serializers>

namespace
{

[[maybe_unused]] const bool kAreSerializersRegistered = osgTerrainROAM::registerSerializers();

} // namespace
