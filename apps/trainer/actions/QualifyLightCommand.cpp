// SPDX-License-Identifier: Apache-2.0
#include "QualifyLightCommand.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include <foundation/DataFile.h>
#include <unistd.h>

#include "terminal/Terminal.h"

namespace trainer
{

int qualifyLight(const QualifyLightRequest& request)
{
    std::vector<std::string> words{(foundation::programFolder() / "qualify_light").string()};
    if (!request.jsonFile.empty()) words.insert(words.end(), {"--json", request.jsonFile.string()});
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(arguments.front(), arguments.data());
    return terminal::fail("trainer", {words.front(), std::string("cannot be begun: ") + std::strerror(errno),
                                      "build the target qualify_light"});
}

} // namespace trainer
