// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/frameexport.h"

#include "async/outputfile.h"
#include "traffic/trafficline.h"
#include "wire/candumplog.h"

#include <algorithm>

namespace mb {

std::string trafficLine(const TrafficRecord &record, const std::string &link, const WallClock &clock)
{
    const Duration time = std::max(Duration::zero(), clock.unixTime(record.frame.time));
    if (record.isFrame())
        return toCandumpLine(time, link, record.frame);
    return bytesLine(time, link, record.direction, record.bytes);
}

Result<void> exportTraffic(const QString &path, int count, const std::function<const TrafficRecord &(int)> &at,
    const std::string &link, const WallClock &clock)
{
    OutputFile file(path.toStdString());
    MB_TRY_VOID(file.open());
    for (int i = 0; i < count; ++i)
        file.write(trafficLine(at(i), link, clock) + '\n');
    return file.commit();
}

} // namespace mb
