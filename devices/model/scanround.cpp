// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scanround.h"

#include <algorithm>
#include <utility>

namespace mb {

struct ScanRound::Sink final : ScanSink {
    Sink(ScanRound &scanRound, const Family &scanned)
        : round(scanRound)
        , family(scanned)
    {
    }
    void found(const Identity &identity) override { round.found(family, identity); }
    void progress(const Message &what, int passed, int total) override
    {
        if (round.m_options.progress)
            round.m_options.progress(what, passed, total);
    }
    void leftOut(const Message &what) override
    {
        if (!round.m_named)
            round.m_around.leftOut(what);
    }
    [[nodiscard]] std::vector<Identity> remembered() const override
    {
        std::vector<Identity> all = round.m_around.remembered(family);
        if (const auto &named = round.m_named; named && named->family == family.key)
            all.push_back(*named);
        return all;
    }
    [[nodiscard]] std::vector<Identity> known() const override { return round.m_around.known(family); }
    [[nodiscard]] ScanExtent extent() const override { return round.m_options.extent; }
    ScanRound &round;
    const Family &family;
};

ScanRound::ScanRound(Link &link, ScanOptions options, Surroundings surroundings)
    : m_link(link)
    , m_options(std::move(options))
    , m_around(std::move(surroundings))
    , m_scope(m_around.clock)
{
}

ScanRound::~ScanRound()
{
    m_around.ended(m_seen, m_complete);
}

void ScanRound::start()
{
    for (const Family *family : m_around.families) {
        if (family->scan && speaks(*family))
            spawn(family->scan(m_link, m_around.linkClock, sinkOf(*family)));
    }
    if (m_running == 0)
        m_done.set();
}

void ScanRound::startFor(const DeviceSelector &selector)
{
    const auto family
        = std::ranges::find_if(m_around.families, [&selector](const Family *f) { return f->key == selector.family; });
    m_named.emplace();
    m_named->family = selector.family;
    m_named->address = selector.address;
    if (family != m_around.families.end() && (*family)->probe && speaks(**family))
        spawn((*family)->probe(m_link, m_around.linkClock, selector.address, sinkOf(**family)));
    else
        start();
}

bool ScanRound::speaks(const Family &family) const
{
    return std::ranges::find(family.links, m_link.kind()) != family.links.end();
}

ScanRound::Sink &ScanRound::sinkOf(const Family &family)
{
    m_sinks.push_back(std::make_unique<Sink>(*this, family));
    return *m_sinks.back();
}

void ScanRound::spawn(Task<void> task)
{
    ++m_running;
    m_scope.spawn<void>(std::move(task), [this](Result<void> result) {
        if (!result)
            m_error = result.error();
        if (--m_running == 0)
            m_done.set();
    });
}

void ScanRound::found(const Family &family, const Identity &identity)
{
    Device &device = m_around.adopt(family, identity, m_seen);
    if (std::ranges::find(m_seen, &device) == m_seen.end())
        m_seen.push_back(&device);
}

} // namespace mb
