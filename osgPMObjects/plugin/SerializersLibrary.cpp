// SPDX-License-Identifier: Apache-2.0
// The library that OpenSceneGraph loads when a scene file names a class of the namespace osgPMObjects that is
// not registered.
#include <osgPMObjects/Serializers>

namespace
{

[[maybe_unused]] const bool kAreSerializersRegistered = osgPMObjects::registerSerializers();

} // namespace
