// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/frameexport.h"

#include "model/trafficline.h"
#include "wire/candumplog.h"

#include <QSaveFile>

#include <algorithm>

namespace mb {

std::string trafficLine(const TrafficRecord &record, const std::string &link, Duration shift)
{
    const Duration time = std::max(Duration::zero(), record.frame.time.time_since_epoch() + shift);
    if (record.isFrame())
        return toCandumpLine(time, link, record.frame);
    return bytesLine(time, link, record.direction, record.bytes);
}

Result<void> exportTraffic(const QString &path, int count, const std::function<const TrafficRecord &(int)> &at,
    const std::string &link, Duration shift)
{
    QSaveFile file(path);
    const auto failed = [&] {
        return fail(Fault::Refused,
            path.toStdString() + " cannot be written: " + file.errorString().toStdString() + "; choose another place");
    };
    if (!file.open(QIODevice::WriteOnly))
        return failed();
    for (int i = 0; i < count; ++i) {
        const std::string line = trafficLine(at(i), link, shift) + '\n';
        if (file.write(line.data(), static_cast<qint64>(line.size())) < 0)
            return failed();
    }
    if (!file.commit())
        return failed();
    return {};
}

} // namespace mb
