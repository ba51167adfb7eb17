// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pmtool/OrderSubject.h"

namespace pmtool
{

/// The names of all orders, as they stand in tables.
std::vector<std::string> orderNames();

/// An order of a subject, worked out anew.
struct OrderedSubject
{
    std::vector<std::vector<osgPMObjects::core::Triangle>> calls; ///< by draw call
    double ms = 0.0;                                              ///< for the order alone, of the processor
    std::size_t strips = 0, sentVertices = 0; ///< of the orders made of strips: as they would be sent
};

OrderedSubject orderSubject(const OrderSubject& subject, const std::string& order);

/// Vertices transformed for each triangle, by each model of a cache. Every draw call begins with an empty one.
nlohmann::ordered_json transformsPerTriangle(const OrderSubject& subject, const OrderedSubject& ordered);

} // namespace pmtool
