// SPDX-License-Identifier: Apache-2.0
#include "worldtool/Processors.h"

#include <sched.h>

namespace worldtool
{

void limitProcessors(int most)
{
    cpu_set_t processors;
    if (most <= 0 || sched_getaffinity(0, sizeof processors, &processors) != 0) return;
    int kept = 0;
    for (int i = 0; i < CPU_SETSIZE; ++i)
        if (CPU_ISSET(i, &processors) && ++kept > most) CPU_CLR(i, &processors);
    (void)sched_setaffinity(0, sizeof processors, &processors); // it is a limit, not a need
}

} // namespace worldtool
