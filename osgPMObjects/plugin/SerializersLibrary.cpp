// SPDX-License-Identifier: Apache-2.0
// What OpenSceneGraph loads when a scene file names a class of the namespace osgPMObjects and nobody has registered it.
#include <osgPMObjects/Serializers>

namespace
{

[[maybe_unused]] const bool kAreSerializersRegistered = osgPMObjects::registerSerializers();

} // namespace
