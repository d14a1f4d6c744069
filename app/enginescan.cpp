// SPDX-License-Identifier: GPL-3.0-or-later
// Scans: whole, asked for, ended.
#include "app/enginecore.h"

namespace mb {

void EngineCore::scanAll()
{
    for (Link *link : m_session.links())
        scan(*link, ScanExtent::Usual);
}

void EngineCore::scan(Link &link, ScanExtent extent)
{
    Watched &watched = m_watched[&link];
    if (watched.scanning || link.state() != LinkState::Open)
        return;
    watched.scanning = true;
    m_lastScan = m_clock.now();
    touch();
    ScanOptions options;
    options.extent = extent;
    options.progress = [this, &watched](const Message &step, int done, int total) {
        watched.step = step;
        watched.done = done;
        watched.total = total;
        touch();
    };
    watched.scan = std::make_unique<Scope>(m_clock);
    watched.scan->spawn<std::vector<Device *>>(m_session.scan(link, std::move(options)),
        [this, &link](Result<std::vector<Device *>> devices) { scanned(link, devices); });
}

void EngineCore::scanned(Link &link, const Result<std::vector<Device *>> &devices)
{
    endScan(m_watched[&link]);
    m_lastScan = m_clock.now();
    if (!devices)
        notice(Severity::Caution, link.address().shortName(), devices.error().message());
    probeSilent(link);
    playWhenKnown(link);
}

/// Its scope stays until the next scan: this may be called from what it has just finished.
void EngineCore::endScan(Watched &watched)
{
    if (watched.scan)
        watched.scan->clear();
    watched.scanning = false;
    watched.step = {};
    watched.done = 0;
    watched.total = 0;
    touch();
}

void EngineCore::scanEverything(const std::string &address)
{
    if (Link *link = linkUnder(address)) {
        endScan(m_watched[link]);
        scan(*link, ScanExtent::Everything);
    }
}

void EngineCore::cancelScan(const std::string &address)
{
    Link *link = linkUnder(address);
    if (!link || !m_watched[link].scanning)
        return;
    endScan(m_watched[link]);
    notice(Severity::Info, link->address().shortName(), say("the search was cancelled; what it found stays"));
}

} // namespace mb
