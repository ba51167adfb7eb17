// SPDX-License-Identifier: Apache-2.0
#include "terminal/Places.h"

#include <foundation/ReadableFile.h>
#include <foundation/WholeFile.h>
#include <foundation/WritableFolder.h>

namespace terminal
{

foundation::Outcome checkPlaces(const Places& places)
{
    for (const auto& file : places.written)
        if (const auto writable = foundation::checkWritable(file); !writable) return writable;
    for (const auto& [folder, file] : places.folders)
        if (const auto writable = foundation::checkFolderWritable(folder, file); !writable) return writable;
    for (const auto& file : places.read)
        if (!file.empty() && !file.string().starts_with("/vsi"))
            if (const auto readable = foundation::checkReadable(file); !readable) return readable;
    return foundation::success();
}

} // namespace terminal
