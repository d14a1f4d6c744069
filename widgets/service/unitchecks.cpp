// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/unitchecks.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/stateglyph.h"
#include "widgets/common/workbench.h"
#include "widgets/common/wraplayout.h"

#include <QCoreApplication>

#include <algorithm>

namespace mb {
namespace {

struct CheckText {
    Q_DECLARE_TR_FUNCTIONS(mb::UnitChecks)
};

UnitCheck unitsOn(const Snapshot &shot, const LinkView &link)
{
    const auto units = std::ranges::count_if(shot.devices,
        [&link](const DeviceView &device) { return device.link == link.address && device.liveness.heard; });
    if (units == 0)
        return {GlyphState::Waiting, CheckText::tr("no unit answers yet")};
    return {GlyphState::Done, CheckText::tr("%n units answer, one at a time", nullptr, static_cast<int>(units))};
}

UnitCheck motionOn(const Snapshot &shot, const LinkView &link)
{
    for (const DeviceView &device : shot.devices) {
        if (device.link == link.address && (device.motion.running || device.mayTurn))
            return {GlyphState::Warning, CheckText::tr("%1 may turn").arg(titleOf(device))};
    }
    return {GlyphState::Done, CheckText::tr("no motor turns")};
}

} // namespace

std::vector<UnitCheck> checksOf(const Snapshot &shot, const JournalState &journal, const std::string &link)
{
    const auto found = std::ranges::find(shot.links, link, &LinkView::address);
    std::vector<UnitCheck> checks;
    if (found == shot.links.end() || found->state != LinkState::Open) {
        checks.push_back({GlyphState::Warning, CheckText::tr("no link is open")});
    } else {
        checks.push_back({GlyphState::Done, CheckText::tr("%1 is open").arg(qt(found->name))});
        checks.push_back(unitsOn(shot, *found));
        checks.push_back(motionOn(shot, *found));
    }
    checks.push_back(journal.trouble.empty()
            ? UnitCheck{GlyphState::Done, CheckText::tr("the journal takes entries")}
            : UnitCheck{GlyphState::Warning, CheckText::tr("the journal keeps entries on this computer")});
    return checks;
}

UnitChecks::UnitChecks(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const Theme &look = theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    auto *line = new QWidget(this);
    m_row = new WrapLayout(line);
    m_row->setContentsMargins(look.u(16), look.u(6), look.u(16), look.u(6));
    m_row->setSpacing(look.u(16));
    m_row->setLineSpacing(look.u(4));
    m_row->addWidget(new SectionLabel(tr("Before each unit"), line));
    column->addWidget(line);
    column->addWidget(separatorLine(Qt::Horizontal, this));
}

void UnitChecks::add()
{
    Item item;
    item.box = new QWidget(m_row->parentWidget());
    auto *row = layoutIn<QHBoxLayout>(item.box, m_theme.theme().u(6));
    row->addWidget(item.glyph = new StateGlyph(m_theme, GlyphState::Done, item.box));
    row->addWidget(item.words = textLabel({}, TextRole::Body, Tone::Text, item.box));
    m_row->addWidget(item.box);
    m_items.push_back(item);
}

void UnitChecks::show(const std::vector<UnitCheck> &checks)
{
    if (checks == m_checks)
        return;
    m_checks = checks;
    while (m_items.size() < checks.size())
        add();
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        m_items[i].box->setVisible(i < checks.size());
        if (i >= checks.size())
            continue;
        m_items[i].glyph->setState(checks[i].glyph);
        m_items[i].words->setText(checks[i].words);
    }
}

QString UnitChecks::text() const
{
    QStringList words;
    for (const UnitCheck &check : m_checks)
        words << check.words;
    return words.join(QStringLiteral(", "));
}

} // namespace mb
