// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/scenario/VehicleControllers.h"
#include "simulation/control/scenario/VehicleFiles.h"

namespace simulation
{
namespace
{

constexpr std::string_view kRecordedProperties[] = {"inputs"};

foundation::Result<std::unique_ptr<VehicleController>> makeRecorded(ControllerProperties& properties,
                                                                    const ControllerSite& site)
{
    const std::filesystem::path inputs = properties.file("inputs", "");
    if (properties.error()) return *properties.error();
    if (inputs.empty())
        return foundation::Error{"property inputs", "is missing",
                                 "name an inputs file (docs/reference/inputs-file.md)"};
    return openInputs(inputs, site.vehicle);
}

} // namespace

VehicleControllerMaker recordedController()
{
    return {"RecordedInputs", kRecordedProperties, makeRecorded};
}

} // namespace simulation
